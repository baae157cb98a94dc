#include "base/math.h"

#include <cmath>
#include <cstdint>

namespace repose {
namespace {

// ln 2 in two parts: the first has trailing zeros, so that its multiples are exact
constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;

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

SineCosine sin_cos_reproducible(double angle) {
  // The nearest multiple of pi/2 goes off in three parts, of which the first two have 33 bits, so that their products
  // with the whole number are exact.
  constexpr double part1 = 0x1.921fb544p+0;
  constexpr double part2 = 0x1.0b4611a6p-34;
  constexpr double part3 = 0x1.3198a2e037073p-69;
  const double quarters = std::floor(angle * (2.0 / pi) + 0.5);
  const double x = ((angle - quarters * part1) - quarters * part2) - quarters * part3;
  const double x2 = x * x;  // |x| <= pi/4: the series end below 1e-19
  double sine = 0.0;
  double cosine = 0.0;
  for (int k = 18; k >= 2; k -= 2) {
    sine = x2 / (k * (k + 1.0)) * (1.0 - sine);
    cosine = x2 / (k * (k - 1.0)) * (1.0 - cosine);
  }
  sine = x - x * sine;
  cosine = 1.0 - cosine;
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

}  // namespace repose
