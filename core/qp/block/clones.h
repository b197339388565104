/// Loops for wide registers beside plain ones, chosen when the program starts; the bits are the same.
#pragma once

// Clang 14 makes both but no symbol that other files find.
#if defined(__GNUC__) && !defined(__clang__)
#define WUERFEL_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define WUERFEL_CLONES
#endif
