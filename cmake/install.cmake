# What `cmake --install` puts where. The program has templates, devices and harness compiled in, and
# finds everything from any prefix. Components: program (with pages and completions), library,
# development, python.
include(GNUInstallDirs)

install(TARGETS mixcmp RUNTIME COMPONENT program)

# Manual pages and completions come from the option tables that --help prints.
set(pages ${PROJECT_BINARY_DIR}/man1)
set(completions ${PROJECT_BINARY_DIR}/completions)
file(MAKE_DIRECTORY ${completions})
add_custom_command(
  OUTPUT ${pages}/mixcmp.1 ${completions}/mixcmp ${completions}/_mixcmp ${completions}/mixcmp.fish
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
  COMMAND mixcmp manual -o ${pages}
  COMMAND sh -c "\"$0\" completion bash >mixcmp && \"$0\" completion zsh >_mixcmp && \"$0\" completion fish >mixcmp.fish"
          $<TARGET_FILE:mixcmp>
  DEPENDS mixcmp
  WORKING_DIRECTORY ${completions}
  COMMENT "Writing manual pages and completions"
  VERBATIM)
add_custom_target(mixcmp_pages ALL DEPENDS ${pages}/mixcmp.1)
install(DIRECTORY ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${completions}/mixcmp COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${completions}/_mixcmp COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${completions}/mixcmp.fish COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# README and its pages keep their folders, so that links between them lead somewhere.
install(FILES README.md LICENSE CHANGELOG.md CONTRIBUTING.md SECURITY.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
        PATTERN "make*" EXCLUDE
        PATTERN "*.awk" EXCLUDE
        PATTERN "data.sh" EXCLUDE
        PATTERN "plan.gnuplot" EXCLUDE)
install(FILES rtl_templates/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/rtl_templates
        COMPONENT program)
foreach(folder bound engine fixed fp stream technology verdict)
  install(FILES rtl_templates/${folder}/README.md COMPONENT program
          DESTINATION ${CMAKE_INSTALL_DOCDIR}/rtl_templates/${folder})
endforeach()
# Scenes and their data; scripts that build in a clone stay there.
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
        PATTERN "run" EXCLUDE
        PATTERN "table" EXCLUDE
        PATTERN "characterise" EXCLUDE
        PATTERN "explore" EXCLUDE
        PATTERN "paper" EXCLUDE)

# find_package(mixcmp) gives mixcmp::mixcmp: the shared library and its one header.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mixcmp)
install(TARGETS mixcmp_shared EXPORT mixcmpTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
                NAMELINK_COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES generator/faces/api/mixcmp.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mixcmp
        COMPONENT development)
install(EXPORT mixcmpTargets NAMESPACE mixcmp:: FILE mixcmpConfig.cmake DESTINATION ${package}
        COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mixcmpConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mixcmpConfigVersion.cmake DESTINATION ${package}
        COMPONENT development)
configure_file(cmake/mixcmp.pc.in ${PROJECT_BINARY_DIR}/mixcmp.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mixcmp.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
