// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Before a function of plain loops: compiled for several generations of x86-64, with all that it calls as a
// part of each version ("flatten"); the fastest that the machine has is taken at run time. Elsewhere, and
// under sanitizers (which cannot run inside the choice), it is compiled once.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(LPS_SCALAR_ONLY)
// AVX-512. Compilers before GCC 12 know it by the names of Intel's processors only.
#if __GNUC__ >= 12
#define LPS_WIDEST "arch=x86-64-v4"
#else
#define LPS_WIDEST "arch=skylake-avx512"
#endif
#define LPS_MULTIVERSION __attribute__((flatten, target_clones(LPS_WIDEST, "avx2", "default")))
#else
#define LPS_MULTIVERSION
#endif

// Before a loop: what it writes is not what it reads in a later round, which the compiler need not check.
#if defined(__GNUC__) && !defined(__clang__)
#define LPS_INDEPENDENT _Pragma("GCC ivdep")
#else
#define LPS_INDEPENDENT
#endif
