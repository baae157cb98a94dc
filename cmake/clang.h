#pragma once

// What the sources ask of GCC and clang 14 does not have; included before every file that clang compiles.
template <class Vector, class Indices>
[[gnu::always_inline]] inline Vector __builtin_shuffle(const Vector& a, const Vector& b, const Indices& from) {
  return Vector{from[0] < 4 ? a[from[0]] : b[from[0] - 4], from[1] < 4 ? a[from[1]] : b[from[1] - 4],
                from[2] < 4 ? a[from[2]] : b[from[2] - 4], from[3] < 4 ? a[from[3]] : b[from[3] - 4]};
}
