/// Loops for wide registers beside plain ones, chosen when the program starts; the bits are the same.
#pragma once

// Clang 14 makes both but no symbol that other files find. GCC's thread sanitizer is not there yet when they are chosen.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define WUERFEL_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define WUERFEL_CLONES
#endif
