# Writes a C++ file that holds the text of every scenario under SCENARIOS.
# Usage: cmake -DSCENARIOS=dir -DOUTPUT=file.cpp -P embed_scenarios.cmake
file(GLOB files RELATIVE ${SCENARIOS} ${SCENARIOS}/*/*.toml)
list(SORT files)
set(rows "")
foreach(file IN LISTS files)
  if(NOT file MATCHES "^(courses|gallery|steering|bench)/")
    message(FATAL_ERROR "${file}: scenarios lie in courses, gallery, steering or bench")
  endif()
endforeach()
foreach(group courses gallery steering bench)
  foreach(file IN LISTS files)
    if(file MATCHES "^${group}/(.+)\\.toml$")
      set(name ${CMAKE_MATCH_1})
      file(READ ${SCENARIOS}/${file} text)
      string(APPEND rows "    {\"${name}\", \"${group}\", R\"~~~(${text})~~~\"},\n")
    endif()
  endforeach()
endforeach()
set(content "// The shipped scenarios, embedded when the library is built.
#include <sturnus/scenario.h>

namespace sturnus {

const std::vector<ShippedScenario>& shipped_scenarios() {
  static const std::vector<ShippedScenario> all = {
${rows}  };
  return all;
}

}  // namespace sturnus
")
file(WRITE ${OUTPUT} "${content}")
