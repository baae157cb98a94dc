#pragma once

namespace repose {

inline constexpr double pi = 3.141592653589793;
inline constexpr double degree = pi / 180.0;  ///< rad

/// Natural logarithm of x > 0, within 2 ulp, by arithmetic only: the same bits on every machine. (libm chooses variants
/// with fused multiply-adds at load time, whose results differ.)
double log_reproducible(double x);

/// e^x for x that neither overflows nor underflows, within 2 ulp, by arithmetic only.
double exp_reproducible(double x);

/// x^(1/5) for x > 0, within 2 ulp, by arithmetic only (Newton's iteration from a power of two).
double fifth_root(double x);

/// Arc tangent in rad, within 2 ulp, by arithmetic only.
double atan_reproducible(double x);

/// x^n for a whole n >= 0, by multiplications only.
double whole_power(double x, double n);

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in radians, |angle| < 1e6, within 2 ulp but near the zeros beyond the first, where the
/// error is below 1e-16; by arithmetic only.
SineCosine sin_cos_reproducible(double angle);

/// Sine and cosine of an angle that is so many right angles greater, exactly.
SineCosine turned_by_quarters(const SineCosine& angle, double quarters);

}  // namespace repose
