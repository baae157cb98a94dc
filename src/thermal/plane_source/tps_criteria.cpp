#include "thermal/plane_source/tps_criteria.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/distributions.h"
#include "thermal/moments.h"

namespace repose::thermal {
namespace {

/// Greatest step between successive residuals over the standard deviation of the steps; that from their median, which
/// a jump does not widen. Rounding of a perfect fit is no jump.
double greatest_jump(const std::vector<double>& residual, double rise) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < residual.size(); ++i) steps.push_back(std::abs(residual[i] - residual[i - 1]));
  const double greatest = *std::max_element(steps.begin(), steps.end());
  const auto middle = steps.begin() + std::ssize(steps) / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  constexpr double normal_median = 0.6745;  // of |x| for a standard normal x
  return greatest / std::max(*middle / normal_median, 1e-7 * rise);
}

Criterion drift(const Transient& t, const TpsSetup& setup, const TpsLimits& limits) {
  Criterion c{
      "drift",
      false,
      {},
      fmt::format(
          "recorded for {} s before time 0; over the transient's time at most {} of the rise, or not significant",
          limits.drift_duration, limits.max_drift)};
  constexpr std::size_t fewest = 10;
  // Samples at a constant rate: the first of them is a step after the beginning of the record at the latest.
  const double recorded = t.idle_time.size() < fewest
                              ? 0.0
                              : (t.idle_time.back() - t.idle_time.front()) * static_cast<double>(t.idle_time.size()) /
                                    static_cast<double>(t.idle_time.size() - 1);
  if (t.idle_time.size() < fewest || recorded < limits.drift_duration * (1.0 - 1e-9)) {
    c.is_met = limits.drift_duration == 0.0;  // it is not asked for
    return c;
  }
  const Slope slope = slope_of(t.idle_time, t.idle_rise);
  c.value = std::abs(slope.value) * used(t.time, setup).back() / std::abs(used(t.rise, setup).back());
  const double significant = student_quantile(0.9995, static_cast<double>(t.idle_time.size()) - 2.0);
  c.is_met = *c.value <= limits.max_drift || std::abs(slope.value) <= significant * slope.standard_error;
  return c;
}

Criterion at_most(const char* name, double value, double limit, const std::string& wanted) {
  return {name, value <= limit, value, wanted};
}
Criterion not_below(const char* name, double value, double limit, const std::string& wanted) {
  return {name, value >= limit, value, wanted};
}

}  // namespace

Slope slope_of(const std::vector<double>& time, const std::vector<double>& rise) {
  const double mean_time = mean_of(time);
  const double mean_rise = mean_of(rise);
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    product += (time[i] - mean_time) * (rise[i] - mean_rise);
    square += (time[i] - mean_time) * (time[i] - mean_time);
  }
  const double slope = product / square;
  double misfit = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double residual = rise[i] - mean_rise - slope * (time[i] - mean_time);
    misfit += residual * residual;
  }
  return {slope, std::sqrt(misfit / (static_cast<double>(time.size()) - 2.0) / square)};
}

double runs_deviate(const std::vector<double>& residual) {
  double above = 0.0;
  double runs = 1.0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    if (residual[i] > 0.0) above += 1.0;
    if (i > 0 && (residual[i] > 0.0) != (residual[i - 1] > 0.0)) runs += 1.0;
  }
  const auto n = static_cast<double>(residual.size());
  const double product = 2.0 * above * (n - above);
  if (product == 0.0) return -std::numeric_limits<double>::infinity();
  const double expected = product / n + 1.0;
  const double variance = product * (product - n) / (n * n * (n - 1.0));
  return (runs - expected) / std::sqrt(variance);
}

std::vector<Criterion> check_criteria(const Transient& transient, const TpsSetup& setup, const TpsFit& fit,
                                      const TpsLimits& limits) {
  const double rise = used(transient.rise, setup).back();
  const double end = used(transient.time, setup).back();
  std::vector<Criterion> all;
  all.push_back(drift(transient, setup, limits));
  all.push_back(at_most("continuity", greatest_jump(fit.residual, rise), limits.max_jump,
                        fmt::format("no step between residuals above {} standard deviations", limits.max_jump)));
  all.push_back({"total_rise", rise >= limits.min_rise && rise <= limits.max_rise, rise,
                 fmt::format("{} to {} K", limits.min_rise, limits.max_rise)});
  all.push_back(not_below("contact_left_out", static_cast<double>(setup.first),
                          static_cast<double>(limits.min_left_out),
                          fmt::format("at least the first {} points left out", limits.min_left_out)));
  all.push_back(not_below("points_used", static_cast<double>(fit.residual.size()),
                          static_cast<double>(limits.min_points),
                          fmt::format("at least {} points", limits.min_points)));
  all.push_back(at_most("straight_line", fit.straightness, limits.max_straightness,
                        fmt::format("1 - R^2 at most {}", limits.max_straightness)));
  all.push_back(at_most("probing_depth", 2.0 * std::sqrt(fit.diffusivity.value * end), limits.available_depth,  // (5.6)
                        fmt::format("at most {} m, the boundary of the sample", limits.available_depth)));
  all.push_back({"mean_deviation", fit.mean_deviation < limits.max_mean_deviation, fit.mean_deviation,
                 fmt::format("below {} K", limits.max_mean_deviation)});
  all.push_back(not_below("residual_pattern", runs_deviate(fit.residual), limits.min_runs_deviate,
                          fmt::format("deviate of the number of runs at least {}", limits.min_runs_deviate)));
  if (!transient.power.empty()) {
    double furthest = 0.0;
    for (const double p : std::span(transient.power).first(transient.power.size() - setup.last))
      furthest = std::max(furthest, std::abs(p / setup.power - 1.0));
    all.push_back(at_most("constant_power", furthest, limits.max_power_deviation,
                          fmt::format("within {} of its mean", limits.max_power_deviation)));
  }
  return all;
}

}  // namespace repose::thermal
