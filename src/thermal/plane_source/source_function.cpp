#include "thermal/plane_source/source_function.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "heat/gauss.h"

namespace repose::thermal {
namespace {

constexpr std::size_t cells = 1000;

double asymptotic(int order, double z) {
  const double mu = 4.0 * order * order;
  double sum = 1.0;
  double term = 1.0;
  for (int k = 1; k < 60; ++k) {
    const double odd = 2.0 * k - 1.0;
    const double next = -term * (mu - odd * odd) / (k * 8.0 * z);
    if (std::abs(next) >= std::abs(term)) break;  // it diverges from here on
    term = next;
    sum += term;
    if (std::abs(term) < 1e-17) break;
  }
  return sum / std::sqrt(2.0 * pi * z);
}

double series(int order, double z) {
  const double quarter = 0.25 * z * z;
  double term = order == 0 ? 1.0 : 0.5 * z;
  double sum = term;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= quarter / (k * (k + static_cast<double>(order)));
    sum += term;
  }
  return std::exp(-z) * sum;
}

/// dD/dsigma of a disc (T.3); 1 for sigma -> 0.
double disc_slope(double sigma) {
  const double z = 0.5 / (sigma * sigma);
  return 1.0 - (scaled_bessel(0, z) + scaled_bessel(1, z));
}

/// dD/dsigma of m rings (T.2). The exponentials are joined: e^{-(l^2+k^2)a/2} I_0(lka) = e^{-(l-k)^2 a/2} [e^{-lka}
/// I_0(lka)].
double ring_slope(std::int64_t rings, double sigma) {
  const auto m = static_cast<double>(rings);
  const double a = 0.5 / (m * m * sigma * sigma);
  double sum = 0.0;
  for (std::int64_t i = 1; i <= rings; ++i) {
    for (std::int64_t j = 1; j <= i; ++j) {
      const auto l = static_cast<double>(i);
      const auto k = static_cast<double>(j);
      const double exponent = 0.5 * (l - k) * (l - k) * a;
      if (exponent > 700.0) continue;
      sum += (i == j ? 1.0 : 2.0) * l * k * std::exp(-exponent) * scaled_bessel(0, l * k * a);
    }
  }
  return sum / (m * m * (m + 1.0) * (m + 1.0) * sigma * sigma);
}

}  // namespace

double scaled_bessel(int order, double z) { return z < 30.0 ? series(order, z) : asymptotic(order, z); }

SourceFunction SourceFunction::disc() { return {0, min_tau}; }

SourceFunction SourceFunction::of_rings(std::int64_t rings, double cutoff) { return {rings, cutoff}; }

double SourceFunction::slope(double sigma) const { return rings_ == 0 ? disc_slope(sigma) : ring_slope(rings_, sigma); }

SourceFunction::SourceFunction(std::int64_t rings, double cutoff)
    : rings_(rings), cutoff_(cutoff), first_log_(std::log(cutoff)), step_((std::log(max_tau) - first_log_) / cells) {
  // The disc is analytic below the grid: dD/dtau = 1 - 2 tau/sqrt(pi) + O(tau^3).
  double sum = rings == 0 ? cutoff - cutoff * cutoff / std::sqrt(pi) : 0.0;
  const auto log_slope = [&](double log_sigma) {
    const double sigma = std::exp(log_sigma);
    return sigma * slope(sigma);
  };
  for (std::size_t i = 0; i <= cells; ++i) {
    const double begin = first_log_ + step_ * static_cast<double>(i);
    value_.push_back(sum);
    log_slope_.push_back(log_slope(begin));
    sum += gauss_integral(begin, begin + step_, log_slope);
  }
}

double SourceFunction::operator()(double tau) const {
  if (tau <= cutoff_) return rings_ == 0 ? tau - tau * tau / std::sqrt(pi) : 0.0;
  const double place = std::min((std::log(tau) - first_log_) / step_, static_cast<double>(cells));
  const auto i = std::min(static_cast<std::size_t>(place), cells - 1);
  const double x = place - static_cast<double>(i);
  const double y = 1.0 - x;
  return y * y * (1.0 + 2.0 * x) * value_[i] + x * x * (3.0 - 2.0 * x) * value_[i + 1] +
         step_ * x * y * (y * log_slope_[i] - x * log_slope_[i + 1]);  // cubic with the derivatives at both ends
}

double SourceFunction::derivative(double tau) const {
  if (tau <= cutoff_) return rings_ == 0 ? 1.0 - 2.0 * tau / std::sqrt(pi) : 0.0;
  const double place = std::min((std::log(tau) - first_log_) / step_, static_cast<double>(cells));
  const auto i = std::min(static_cast<std::size_t>(place), cells - 1);
  const double x = place - static_cast<double>(i);
  const double y = 1.0 - x;
  return (6.0 * x * y * (value_[i + 1] - value_[i]) / step_ + y * (1.0 - 3.0 * x) * log_slope_[i] +
          x * (3.0 * x - 2.0) * log_slope_[i + 1]) /
         tau;  // of the same cubic
}

}  // namespace repose::thermal
