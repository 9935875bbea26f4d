# Writes a C++ file that holds the text of the Shadertoy tabs in SHADERS.
# Usage: cmake -DSHADERS=dir -DOUTPUT=file.cpp -P embed_shaders.cmake
set(content "// The Shadertoy tabs, embedded when the library is built.
#include \"shaders/tabs.h\"

namespace sturnus {
")
foreach(tab common buffer_a image)
  file(READ ${SHADERS}/${tab}.glsl text)
  string(APPEND content "\nconst char* const ${tab}_tab = R\"~~~(${text})~~~\";\n")
endforeach()
string(APPEND content "\n}  // namespace sturnus\n")
file(WRITE ${OUTPUT} "${content}")
