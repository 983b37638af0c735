# Run by CPack before it makes the Debian packages, on the folders that hold their files: one for each
# component, named like it.
set(changes ${CPACK_TEMPORARY_DIRECTORY}/changelog.Debian)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A changelog of the package: the last version that CHANGELOG.md names, of its day.
file(STRINGS ${CPACK_MIXCMP_SOURCE}/CHANGELOG.md headings REGEX "^## [0-9]")
list(GET headings 0 heading)
if(NOT heading MATCHES "^## ([0-9.]+), ([0-9-]+)$" OR
   NOT CMAKE_MATCH_1 STREQUAL CPACK_PACKAGE_VERSION)
  message(FATAL_ERROR "CHANGELOG.md begins with \"${heading}\", not with \
\"## ${CPACK_PACKAGE_VERSION}, YEAR-MONTH-DAY\"")
endif()
execute_process(COMMAND date -u -R -d ${CMAKE_MATCH_2} OUTPUT_VARIABLE day
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(doc ${root}/share/doc/${package})
  file(WRITE ${doc}/changelog.Debian
"mixcmp (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}: see CHANGELOG.md in the package mixcmp.

 -- ${CPACK_PACKAGE_CONTACT}  ${day}
")
  run(gzip -9nf ${doc}/changelog.Debian)
  # The licences of all files, in the format that both REUSE and Debian read.
  configure_file(${CPACK_MIXCMP_SOURCE}/.reuse/dep5 ${doc}/copyright COPYONLY)
  file(GLOB pages ${root}/share/man/man1/*.1)
  if(pages)
    run(gzip -9nf ${pages})
  endif()
  if(EXISTS ${doc}/LICENSE)
    # Debian has the text itself, in /usr/share/common-licenses.
    file(REMOVE ${doc}/LICENSE)
    file(CREATE_LINK copyright ${doc}/LICENSE SYMBOLIC)
  endif()
endforeach()
