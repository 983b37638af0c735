# Everything here is a Debian package; the README lists them, tests/run and examples/run install them.
find_package(PkgConfig REQUIRED)
pkg_check_modules(MPFR REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(GMPXX REQUIRED IMPORTED_TARGET gmpxx)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(pegtl REQUIRED)
