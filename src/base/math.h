#pragma once

namespace repose {

inline constexpr double pi = 3.141592653589793;

/// Natural logarithm of x > 0, within 2 ulp, by arithmetic only: the same bits on every machine. (libm chooses variants
/// with fused multiply-adds at load time, whose results differ.)
double log_reproducible(double x);

/// Sine and cosine of an angle in rad, |angle| < 1e6, within 2 ulp of the greater of the two, by arithmetic only.
struct SineCosine {
  double sine;
  double cosine;
};
SineCosine sin_cos_reproducible(double angle);

/// e^x for x that neither overflows nor underflows, within 2 ulp, by arithmetic only.
double exp_reproducible(double x);

/// x^(1/5) for x > 0, within 2 ulp, by arithmetic only (Newton's iteration from a power of two).
double fifth_root(double x);

}  // namespace repose
