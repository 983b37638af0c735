# Debian packages, by `cpack -G DEB` in a build folder of the preset "package" (tests/package does it
# all): mixcmp, libmixcmp0.1, libmixcmp-dev and, where it was built, python3-mixcmp.
set(CPACK_PACKAGE_CONTACT "mixcmp maintainers <mixcmp@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "numerical comparisons as verified Verilog")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program library development)
if(TARGET mixcmp_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
# Compresses manual pages; gives each package its copyright and changelog.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_files.cmake)
set(CPACK_MIXCMP_SOURCE ${PROJECT_SOURCE_DIR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME mixcmp)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION electronics)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"mixcmp turns a numerical comparison, the sign of f(x) - g(y), into Verilog
that decides it in reduced precision where an error bound proves that
enough, and recomputes in a reference precision where not. It simulates
what it generated on real data, and holds every verdict against a model.")
# Each disables only itself where it is missing: mixcmp doctor.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS
    "verilator, g++, make, iverilog, yosys, nextpnr-ice40, gappa, gnuplot-nox")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ccache, glpk-utils, gtkwave")

set(library libmixcmp${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# What dpkg refreshes the linker's cache by. CPack calls ldconfig in scripts, too.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/triggers)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"The C++ library of mixcmp: from a scene to Verilog, to the verdicts of its
hardware, to the counts of a profile and to a plan.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmixcmp-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION}-1)")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"The header of the C++ library of mixcmp, for find_package(mixcmp) and
pkg-config.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-mixcmp)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/python/postinst
                                              ${CMAKE_CURRENT_LIST_DIR}/debian/python/prerm)
if(TARGET mixcmp_python)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"The Python module of mixcmp: scene, emulator, profile and plan, with NumPy
arrays in and out.")
include(CPack)
