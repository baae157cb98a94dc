#include "base/math.h"

#include <cmath>
#include <cstdint>

namespace repose {
namespace {

// ln 2 in two parts: the first has trailing zeros, so that its multiples are exact
constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;

constexpr double square_root_of_2 = 1.4142135623730951;

}  // namespace

double log_reproducible(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // exact: x = mantissa 2^exponent, mantissa in [0.5, 1)
  if (mantissa < 0.7071067811865476) {
    mantissa *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh(s), s = (m-1)/(m+1), |s| < 0.172: the series converges as s^(2k+1)/(2k+1)
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int k = 23; k >= 3; k -= 2) series = s2 * (series + 1.0 / k);
  const double e = exponent;
  return e * ln2_high + (2.0 * s + (2.0 * s * series + e * ln2_low));
}

double exp_reproducible(double x) {
  const double n = std::floor(x / (ln2_high + ln2_low) + 0.5);
  const double r = (x - n * ln2_high) - n * ln2_low;  // |r| <= ln 2 / 2: the series ends below half an ulp
  double series = 1.0;
  for (int k = 14; k >= 2; --k) series = 1.0 + r / k * series;
  return std::ldexp(1.0 + r * series, static_cast<int>(n));
}

double fifth_root(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  const int root_exponent = exponent / 5 + 1;  // a start above the root: Newton then falls monotonically
  double y = std::ldexp(1.0, root_exponent);
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double y2 = y * y;
    const double next = y - (y - x / (y2 * y2)) / 5.0;
    if (!(next < y)) break;
    y = next;
  }
  return y;
}

double atan_reproducible(double x) {
  double s = std::fabs(x);
  double known = 0.0;  // an angle to which that of the rest is added
  if (s > 1.0 + square_root_of_2) {
    known = 0.5 * pi;
    s = -1.0 / s;
  } else if (s > square_root_of_2 - 1.0) {
    known = 0.25 * pi;
    s = (s - 1.0) / (s + 1.0);
  }
  const double s2 = s * s;  // |s| < 0.415: the series of s^(2k+1)/(2k+1) ends below half an ulp
  double series = 0.0;
  for (int k = 43; k >= 3; k -= 2) series = s2 * (1.0 / k - series);
  const double angle = known + (s - s * series);
  return x < 0.0 ? -angle : angle;
}

double whole_power(double x, double n) {
  double power = 1.0;
  for (double left = n; left > 0.0; left = std::floor(0.5 * left)) {
    if (left - 2.0 * std::floor(0.5 * left) == 1.0) power *= x;
    x *= x;
  }
  return power;
}

SineCosine sin_cos_reproducible(double angle) {
  // pi/2 in three parts: the first two have trailing zeros, so that their multiples are exact
  constexpr double half_pi_high = 1.57079632673412561417e+00;
  constexpr double half_pi_middle = 6.07710050630396597660e-11;
  constexpr double half_pi_low = 2.02226624879595063154e-21;
  const double quarters = std::floor(angle * (2.0 / pi) + 0.5);
  const double above = angle - quarters * half_pi_high;
  const double middle = quarters * half_pi_middle;
  const double x = above - middle;
  const double rest = ((above - x) - middle) - quarters * half_pi_low;  // the angle is x + rest
  const double x2 = x * x;
  double sine_tail = 0.0;    // sin x = x (1 + sine_tail), |x| < 0.79
  double cosine_tail = 0.0;  // cos x = 1 - x^2/2 (1 + cosine_tail)
  for (int k = 19; k >= 3; k -= 2) sine_tail = -x2 / (k * (k - 1)) * (1.0 + sine_tail);
  for (int k = 20; k >= 4; k -= 2) cosine_tail = -x2 / (k * (k - 1)) * (1.0 + cosine_tail);
  const double sine = x + (x * sine_tail + rest);
  const double near_one = 1.0 - 0.5 * x2;
  const double cosine = near_one + (((1.0 - near_one) - 0.5 * x2) - (0.5 * x2 * cosine_tail + x * rest));
  return turned_by_quarters({sine, cosine}, quarters);
}

SineCosine turned_by_quarters(const SineCosine& angle, double quarters) {
  const auto [sine, cosine] = angle;
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace repose
