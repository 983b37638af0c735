# mixcmp_commit(TARGET target HEADER header NAMESPACE mixcmp::cli)
# Compiles into `target` the function that HEADER declares:
#   namespace mixcmp::cli { const char* commit(); }
# the commit that the sources are of, ", modified" behind it where tracked files differ from that
# commit, or "unknown" outside of a clone. Every build asks git; where the answer is that of the last
# build, nothing is compiled or linked again. An archive made by `git archive` needs no git: it says
# its commit in cmake/commit.txt.
# The same file, run as a script, writes the source at build time.

function(mixcmp_commit)
  cmake_parse_arguments(COMMIT "" "TARGET;HEADER;NAMESPACE" "" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/commit.cpp)
  find_package(Git QUIET)
  add_custom_target(${COMMIT_TARGET}_commit
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${PROJECT_SOURCE_DIR} -D GIT=${GIT_EXECUTABLE}
            -D HEADER=${COMMIT_HEADER} -D NAMESPACE=${COMMIT_NAMESPACE} -D OUTPUT=${source}
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    BYPRODUCTS ${source}
    COMMENT "Asking git for the commit"
    VERBATIM)
  add_dependencies(${COMMIT_TARGET} ${COMMIT_TARGET}_commit)
  target_sources(${COMMIT_TARGET} PRIVATE ${source})
  # A new commit recompiles this source alone, not seven others with it.
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Sets `result` to what git prints; to nothing where there is no git or it fails.
function(mixcmp_ask_git result)
  set(${result} "" PARENT_SCOPE)
  if(NOT GIT)
    return()
  endif()
  execute_process(COMMAND ${GIT} -C ${FOLDER} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text
                  ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(status EQUAL 0)
    set(${result} "${text}" PARENT_SCOPE)
  endif()
endfunction()

# Sets `result` to the commit. A clone of something else around FOLDER does not count.
function(mixcmp_find_commit result)
  file(READ ${FOLDER}/cmake/commit.txt stamped)
  if(stamped MATCHES "^[0-9a-f]+")
    set(${result} ${CMAKE_MATCH_0} PARENT_SCOPE)
    return()
  endif()
  mixcmp_ask_git(prefix rev-parse --show-prefix)
  mixcmp_ask_git(commit rev-parse HEAD)
  if(commit STREQUAL "" OR NOT prefix STREQUAL "")
    set(${result} unknown PARENT_SCOPE)
    return()
  endif()
  mixcmp_ask_git(changes status --porcelain --untracked-files=no)
  if(NOT changes STREQUAL "")
    string(APPEND commit ", modified")
  endif()
  set(${result} ${commit} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  mixcmp_find_commit(commit)
  file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "@HEADER@"

namespace @NAMESPACE@ {

const char* commit() {
  // Of one length, so that programs of two commits differ here alone.
  static const char text[64] = "@commit@";
  return text;
}

}  // namespace @NAMESPACE@
]])
endif()
