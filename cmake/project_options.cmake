# Warnings of the project's own code. They are errors for developers (presets developer and
# debug) and in CI, not for users, whose compilers we do not know.
add_library(mixcmp_options INTERFACE)
target_compile_options(mixcmp_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                -Wno-sign-conversion -Wnon-virtual-dtor
                                                -Wredundant-decls)
# Options are aggregates with defaults, set by name: a missing one is meant.
target_compile_options(mixcmp_options INTERFACE -Wno-missing-field-initializers)
# g++ 12 sees overlaps in concatenated strings that are not there (GCC bug 105329).
target_compile_options(mixcmp_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# g++ collects garbage at 128 MiB unless it is told that it may take more; without it, compiling takes a
# tenth less time.
target_compile_options(mixcmp_options INTERFACE
                       "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=524288>")
# A broken invariant names its source from the repository's root, and the program holds no path of
# the machine that built it.
target_compile_options(mixcmp_options INTERFACE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
target_include_directories(mixcmp_options INTERFACE ${PROJECT_SOURCE_DIR})
# Contracted multiply-adds would change the arithmetic of the tests' own oracles.
target_compile_options(mixcmp_options INTERFACE -ffp-contract=off)

option(MIXCMP_WARNINGS_AS_ERRORS "Treat warnings of the project's own code as errors" OFF)
if(MIXCMP_WARNINGS_AS_ERRORS)
  target_compile_options(mixcmp_options INTERFACE -Werror)
endif()

option(MIXCMP_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
if(MIXCMP_SANITIZE)
  target_compile_options(mixcmp_options INTERFACE -fsanitize=address,undefined
                                                  -fno-sanitize-recover=all)
  target_link_options(mixcmp_options INTERFACE -fsanitize=address,undefined)
  # g++ sees uninitialised variants in instrumented code that are not there. Its manual, at
  # -fsanitize, says to expect that and advises against warnings as errors here.
  target_compile_options(mixcmp_options INTERFACE
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# tests/fuzz: libFuzzer, which clang brings, sees which branches an input takes.
option(MIXCMP_FUZZ "Build the fuzzers of the readers, and no other tests" OFF)
if(MIXCMP_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "MIXCMP_FUZZ needs clang++, which brings libFuzzer: cmake --preset fuzz")
  endif()
  target_compile_options(mixcmp_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
