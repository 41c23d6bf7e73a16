#pragma once

// A function marked so is compiled a second time for AVX2, and the better one is chosen when the program starts.
// Sanitizers are not ready yet at that moment, so they get the plain version.
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PROOFREEL_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
#define PROOFREEL_VECTORISED
#endif
