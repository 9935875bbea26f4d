# Turns a TrueType file into a C++ source with its bytes, so that the library can write without any font installed.
#
# As a script, at build time:   cmake -DFONT=<file.ttf or empty> -DOUTPUT=<file.cpp> -P embed_font.cmake
# Included, at configure time:  sturnus_embed_font(<file.ttf or empty> <file.cpp>)
#
# Without a font the source says so with size 0, and text draws nothing.

function(sturnus_embed_font font output)
  set(bytes "0")
  set(size 0)
  if(font AND EXISTS "${font}")
    file(SIZE "${font}" size)
    file(READ "${font}" hex HEX)
    # Twenty bytes a line keep the source readable for tools that dislike long lines.
    string(REGEX REPLACE "(........................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  endif()
  get_filename_component(name "${font}" NAME)
  file(WRITE "${output}.new" "// Written by cmake/embed_font.cmake from ${name}.
#include \"draw/font.h\"

namespace sturnus {

const unsigned char embedded_font[] = {
${bytes}
};
const unsigned long embedded_font_size = ${size};

}  // namespace sturnus
")
  file(RENAME "${output}.new" "${output}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  if(NOT OUTPUT)
    message(FATAL_ERROR "embed_font.cmake: say -DOUTPUT=<file.cpp>, and -DFONT=<file.ttf> where there is one")
  endif()
  sturnus_embed_font("${FONT}" "${OUTPUT}")
endif()
