# mixcmp_embed(TARGET target NAMESPACE mixcmp::emit SYMBOL name FILES file...)
# Compiles the texts of FILES into `target`, so that the installed program needs no data folder:
#   #include "embedded/name.hpp"  ->  std::span<const EmbeddedFile> mixcmp::emit::name();
# in the order given, each named by its last path component.
# The same file, run as a script, writes the source at build time.

function(mixcmp_embed)
  cmake_parse_arguments(EMBED "" "TARGET;NAMESPACE;SYMBOL" "FILES" ${ARGN})
  set(names)
  set(paths)
  foreach(file IN LISTS EMBED_FILES)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET file FILENAME name)
    if(name IN_LIST names)
      message(FATAL_ERROR "mixcmp_embed(${EMBED_SYMBOL}): two files are named ${name}")
    endif()
    list(APPEND names ${name})
    list(APPEND paths ${file})
  endforeach()

  set(stem ${CMAKE_CURRENT_BINARY_DIR}/embedded/${EMBED_SYMBOL})
  file(CONFIGURE OUTPUT ${stem}.hpp @ONLY CONTENT [[
#pragma once

#include <span>

#include "model/base/common/embedded_file.hpp"

namespace @EMBED_NAMESPACE@ {

std::span<const EmbeddedFile> @EMBED_SYMBOL@();

}  // namespace @EMBED_NAMESPACE@
]])
  # The list of names is an input of the output, too: a file dropped from it leaves no newer file.
  file(CONFIGURE OUTPUT ${stem}.list CONTENT "${paths}")
  add_custom_command(
    OUTPUT ${stem}.cpp
    COMMAND ${CMAKE_COMMAND} -D LIST=${stem}.list -D SYMBOL=${EMBED_SYMBOL}
            -D NAMESPACE=${EMBED_NAMESPACE} -D OUTPUT=${stem}.cpp
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${paths} ${stem}.list ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    COMMENT "Embedding ${EMBED_SYMBOL}"
    VERBATIM)
  target_sources(${EMBED_TARGET} PRIVATE ${stem}.cpp)
  target_include_directories(${EMBED_TARGET} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

function(mixcmp_write_embedded)
  file(READ ${LIST} paths)
  set(entries "")
  foreach(path IN LISTS paths)
    cmake_path(GET path FILENAME name)
    file(READ ${path} text)
    string(APPEND entries "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE ${OUTPUT}
"#include \"embedded/${SYMBOL}.hpp\"

namespace ${NAMESPACE} {

std::span<const EmbeddedFile> ${SYMBOL}() {
  static constexpr EmbeddedFile files[] = {
${entries}  };
  return files;
}

}  // namespace ${NAMESPACE}
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  mixcmp_write_embedded()
endif()
