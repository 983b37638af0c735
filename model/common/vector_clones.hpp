#pragma once

#include <cstddef>  // says whether the C library is glibc

/// Before the definition of a function of plain loops: compiles it for AVX-512 and AVX2, too; when
/// the program is loaded, glibc picks the one that the processor has. What the function calls has
/// to be inlined. Results are the same, since nothing is reassociated, nor contracted
/// (-ffp-contract=off, cmake/project_options.cmake). clang++ 14 wants such attributes at each
/// declaration, and g++'s thread sanitizer is not ready when the choice is made; there the function
/// is compiled once.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define MIXCMP_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define MIXCMP_VECTOR_CLONES
#endif
