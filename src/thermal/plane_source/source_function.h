#pragma once

#include <cstdint>
#include <vector>

namespace repose::thermal {

/// e^-z I_n(z) for n = 0 or 1 and z >= 0, within 1e-14: the power series (https://dlmf.nist.gov/10.25.E2) below z = 30,
/// the asymptotic one (https://dlmf.nist.gov/10.40.E1) above.
double scaled_bessel(int order, double z);

/// The dimensionless rise D(tau) of a transient plane source, tau = sqrt(alpha t)/r (thesis 5.3 to 5.5; theory T.2,
/// T.3). Tabulated once on a logarithmic grid with its exact derivative, so that an evaluation is a cubic; within 1e-9.
class SourceFunction {
 public:
  /// A homogeneous disc (T.3).
  static SourceFunction disc();
  /// `rings` concentric equidistant rings (T.2). The integrand goes like 1/sigma for sigma -> 0, a line source of no
  /// width; the integral begins at `cutoff` > 0, of the order of the strip's half width over the disc's radius. A
  /// change of the cutoff adds a constant to D where tau is well above it, which the evaluation cannot tell from the
  /// contact.
  static SourceFunction of_rings(std::int64_t rings, double cutoff);

  /// D(tau), 0 <= tau <= max_tau.
  double operator()(double tau) const;
  /// dD/dtau.
  double derivative(double tau) const;
  /// 0 for a disc.
  std::int64_t rings() const { return rings_; }
  /// The tau from which on this is D: the cutoff of rings, below which it is 0.
  double least_tau() const { return rings_ == 0 ? 0.0 : cutoff_; }

  static constexpr double min_tau = 1e-4;
  static constexpr double max_tau = 100.0;

 private:
  SourceFunction(std::int64_t rings, double cutoff);
  double slope(double sigma) const;

  std::int64_t rings_;  ///< 0: disc
  double cutoff_;
  double first_log_;  ///< of the grid
  double step_;
  std::vector<double> value_;
  std::vector<double> log_slope_;  ///< dD/dln(tau)
};

}  // namespace repose::thermal
