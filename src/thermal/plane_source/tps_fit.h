#pragma once

#include <span>
#include <string>
#include <vector>

#include "thermal/plane_source/source_function.h"
#include "thermal/plane_source/transient.h"

namespace repose::thermal {

/// A figure with its uncertainty.
struct Estimate {
  double value = 0.0;
  double standard_error = 0.0;
  double low = 0.0;  ///< of the 95 % interval
  double high = 0.0;
};

/// What a fit needs beside the transient.
struct TpsSetup {
  double radius = 0.0;            ///< of the sensor, m
  double power = 0.0;             ///< W, mean over the points that are used
  double power_deviation = 0.0;   ///< relative standard deviation of the power
  double radius_deviation = 0.0;  ///< and of the radius
  std::size_t first = 10;         ///< points left out at the beginning
  std::size_t last = 0;           ///< and at the end
};

/// The values of the points that are used; none when more are left out than there are.
std::span<const double> used(const std::vector<double>& values, const TpsSetup& setup);

/// The straight line of the rise over D(tau), and what follows from it.
struct TpsFit {
  Estimate conductivity;         ///< W/(m K)
  Estimate diffusivity;          ///< m2/s
  Estimate volumetric_heat;      ///< J/(m3 K)
  double intercept = 0.0;        ///< K: the contact term Delta T_i, and what a cutoff of the rings hides
  double slope = 0.0;            ///< K, P/(pi^(3/2) r k)
  std::vector<double> source;    ///< D(tau) of the points used
  std::vector<double> residual;  ///< K
  double mean_deviation = 0.0;   ///< K, root mean square of the residuals
  double straightness = 0.0;     ///< 1 - R^2 of the line
  double characteristic = 0.0;   ///< total time over the characteristic time r^2/alpha
  int iterations = 0;            ///< on the diffusivity
};

/// Varies the diffusivity until the rise over D(tau) is the straightest line, in least squares (thesis section 5.1;
/// theory T.5 to T.7), and takes the conductivity from the slope. The intervals are those of the linearised model in
/// the logarithms, with the variance of the residuals. DeckError, beginning with `name`, when there are too few points,
/// when they do not determine the diffusivity, or when some lie before the cutoff of the rings.
TpsFit fit_transient(const Transient& transient, const TpsSetup& setup, const SourceFunction& source,
                     const std::string& name);

/// Points that a fit must have at least.
inline constexpr std::size_t min_fit_points = 20;

}  // namespace repose::thermal
