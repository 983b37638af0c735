#pragma once

#include <cstddef>  // says whether the C library is glibc

/// To be written in front of a function of plain loops. It also compiles the function for AVX-512
/// and AVX2, and when the program is loaded, glibc picks the clone for the processor. Functions
/// that it calls have to be inlined. Results are the same, since no operation is reassociated or
/// contracted (-ffp-contract=off, cmake/project_options.cmake). clang++ 14 wants these attributes
/// at each declaration, and g++'s thread sanitizer is not ready when glibc picks a clone. With
/// clang++ or that sanitizer, the function is therefore compiled once.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define MIXCMP_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define MIXCMP_VECTOR_CLONES
#endif
