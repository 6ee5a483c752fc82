# cmake -D SOURCE=... -D VERSION=... -D OUT=... -P write_version.cmake
# Writes the source file that holds the program's version: that of the project, and where SOURCE is a
# checkout its commit, 0.2.0+g1a2b3c4d, with "-dirty" after changes that are not committed. Run at
# every build; OUT is touched only when the version has changed.
cmake_minimum_required(VERSION 3.25)
find_program(GIT git)
set(version "${VERSION}")
if(GIT)
  # A tarball may lie inside another project's checkout.
  execute_process(COMMAND ${GIT} rev-parse --show-prefix WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE below OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND below STREQUAL "")
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
              ${GIT} describe --tags --always --dirty --abbrev=8 "--exclude=*"
      WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed)
      string(APPEND version "+g${commit}")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT
"// Written by server/operate/write_version.cmake.
#include \"server/operate/version.hpp\"

namespace leda::server {

const char* version() { return \"${version}\"; }

}  // namespace leda::server
")
