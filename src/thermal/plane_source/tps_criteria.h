#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thermal/plane_source/tps_fit.h"

namespace repose::thermal {

/// What a good transient keeps to (thesis section 5.2). The figures that the thesis does not print are named as such.
struct TpsLimits {
  double min_rise = 2.0;             ///< K, total
  double max_rise = 5.5;             ///< K
  double available_depth = 0.0;      ///< m from the sensor's edge to the nearest boundary of the sample
  double max_mean_deviation = 1e-3;  ///< K; "the order of 1e-3 is a sign of a poor result"
  std::int64_t min_left_out = 10;    ///< points at the beginning
  std::int64_t min_points = 100;     ///< that remain; not printed: half of the 200 that were taken
  double drift_duration = 40.0;      ///< s recorded before the transient
  double max_drift = 1e-3;  ///< over the transient's time, per total rise, if it is significant at 0.1 %; not printed
  double max_jump = 6.0;    ///< between successive residuals, in their standard deviations; not printed
  double min_runs_deviate = -3.09;    ///< of the number of runs of one sign, standard normal; not printed: 0.1 %
  double max_straightness = 1e-5;     ///< 1 - R^2 of the line; not printed
  double max_power_deviation = 0.01;  ///< of the power from its mean, relative; not printed
};

/// One criterion and how the transient meets it.
struct Criterion {
  std::string name;
  bool is_met = false;
  std::optional<double> value;  ///< empty when it could not be found
  std::string wanted;           ///< in words, with the limit
};

/// Each criterion of section 5.2, in a fixed order: drift, continuity, total_rise, contact_left_out, points_used,
/// straight_line, probing_depth, mean_deviation, residual_pattern, and constant_power when the power was recorded. What
/// comes after the last point that is used counts for none of them.
std::vector<Criterion> check_criteria(const Transient& transient, const TpsSetup& setup, const TpsFit& fit,
                                      const TpsLimits& limits);

/// Deviate of the number of runs of one sign, standard normal when the signs are random: Wald and Wolfowitz 1940,
/// doi:10.1214/aoms/1177731909. Far below zero: the residuals follow a pattern. -infinity when all have one sign.
double runs_deviate(const std::vector<double>& residual);

/// Slope of a straight line through points and its standard error, K/s.
struct Slope {
  double value = 0.0;
  double standard_error = 0.0;
};
Slope slope_of(const std::vector<double>& time, const std::vector<double>& rise);

}  // namespace repose::thermal
