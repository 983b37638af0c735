# mixcmp_library(NAME [COLD] [USES name...] [LINKS target...] SOURCES file...)
# The library mixcmp_NAME, made of one folder. USES names the libraries of this project whose
# headers the folder includes; LINKS names what is not ours. COLD: no run spends its time here, so
# that it is compiled with -Og, which GCC 12 does fastest. A library that MIXCMP_BY_SOURCE lists is
# made to be compiled again often, one source at a time (tests/mutate).
set(MIXCMP_BY_SOURCE "" CACHE STRING "Libraries that compile source by source, and fast")
function(mixcmp_library name)
  cmake_parse_arguments(LIBRARY "COLD" "" "USES;LINKS;SOURCES" ${ARGN})
  add_library(mixcmp_${name} STATIC ${LIBRARY_SOURCES})
  if(LIBRARY_COLD)
    target_compile_options(mixcmp_${name} PRIVATE $<$<CONFIG:Release>:-Og>)
  endif()
  if(name IN_LIST MIXCMP_BY_SOURCE)
    set_target_properties(mixcmp_${name} PROPERTIES UNITY_BUILD OFF)
    target_compile_options(mixcmp_${name} PRIVATE -O1 -w)
  endif()
  mixcmp_uses(mixcmp_${name} ${LIBRARY_USES})
  target_link_libraries(mixcmp_${name} PUBLIC mixcmp_options fmt::fmt ${LIBRARY_LINKS})
endfunction()

# mixcmp_uses(TARGET name...)
# Links TARGET, which is made of the current folder, against mixcmp_NAME of each name. tests/includes
# fails on an include of a folder that is not named here.
function(mixcmp_uses target)
  foreach(name IN LISTS ARGN)
    target_link_libraries(${target} PUBLIC mixcmp_${name})
  endforeach()
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
             OUTPUT_VARIABLE folder)
  list(TRANSFORM ARGN PREPEND mixcmp_ OUTPUT_VARIABLE used)
  string(JOIN " " line ${target} ${folder} ${used})
  set_property(GLOBAL APPEND PROPERTY MIXCMP_LIBRARIES ${line})
endfunction()

# Writes what was said to mixcmp_uses, one target a line: "TARGET FOLDER USED...".
function(mixcmp_list_libraries file)
  get_property(libraries GLOBAL PROPERTY MIXCMP_LIBRARIES)
  list(JOIN libraries "\n" text)
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}\n")
endfunction()
