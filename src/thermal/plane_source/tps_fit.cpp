#include "thermal/plane_source/tps_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "base/distributions.h"
#include "base/error.h"
#include "base/math.h"

namespace repose::thermal {
namespace {

/// The points that are used, and the line through them for one diffusivity.
class Line {
 public:
  Line(const Transient& transient, const TpsSetup& setup, const SourceFunction& source)
      : source_(source), radius_(setup.radius) {
    const auto vector_of = [&](const std::vector<double>& values) {
      const std::span<const double> points = used(values, setup);
      return Eigen::Map<const Eigen::VectorXd>(points.data(), std::ssize(points));
    };
    time_ = vector_of(transient.time);
    rise_ = vector_of(transient.rise);
  }

  /// Columns 1, D and dD/dln(alpha) at the points for the logarithm of the diffusivity.
  Eigen::MatrixX3d columns(double log_diffusivity) const {
    Eigen::MatrixX3d matrix(time_.size(), 3);
    const double rate = std::exp(0.5 * log_diffusivity) / radius_;
    for (Eigen::Index i = 0; i < time_.size(); ++i) {
      const double tau = rate * std::sqrt(time_[i]);  // (5.4, 5.5)
      matrix.row(i) << 1.0, source_(tau), 0.5 * tau * source_.derivative(tau);
    }
    return matrix;
  }

  /// Intercept and slope of the line in least squares, from sums about the means. Where all points are below the cutoff
  /// of the rings D does not tell them apart: no slope.
  Eigen::Vector2d line(const Eigen::MatrixX3d& columns) const {
    const Eigen::VectorXd d = columns.col(1).array() - columns.col(1).mean();
    const double squares = d.squaredNorm();
    const double slope = squares > 0.0 ? d.dot(rise_) / squares : 0.0;
    return {rise_.mean() - slope * columns.col(1).mean(), slope};
  }

  Eigen::VectorXd residual(const Eigen::MatrixX3d& columns) const {
    return rise_ - columns.leftCols<2>() * line(columns);
  }
  double misfit(double log_diffusivity) const { return residual(columns(log_diffusivity)).squaredNorm(); }

  const Eigen::VectorXd& time() const { return time_; }
  const Eigen::VectorXd& rise() const { return rise_; }

 private:
  const SourceFunction& source_;
  double radius_;
  Eigen::VectorXd time_;
  Eigen::VectorXd rise_;
};

/// Logarithm of the diffusivity for which the last point has this tau.
double log_diffusivity_at(double tau, double radius, double end) {
  return 2.0 * std::log(tau * radius) - std::log(end);
}

constexpr double lowest_tau = 0.05;  ///< of the last point: D is a straight line over sqrt(t) below
constexpr double highest_tau = 10.0;

/// The minimum of the misfit: the best of a coarse scan, then the golden section.
double best_log_diffusivity(const Line& line, const TpsSetup& setup, const std::string& name, int& iterations) {
  constexpr int steps = 106;
  const double end = line.time()[line.time().size() - 1];
  const double low = log_diffusivity_at(lowest_tau, setup.radius, end);
  const double step = (log_diffusivity_at(highest_tau, setup.radius, end) - low) / steps;
  int best = 0;
  double least = line.misfit(low);
  for (int i = 1; i <= steps; ++i) {
    const double misfit = line.misfit(low + i * step);
    if (misfit < least) {
      least = misfit;
      best = i;
    }
  }
  iterations = steps + 1;
  if (best == 0 || best == steps) {
    throw DeckError(fmt::format(
        "{}: the points do not determine the diffusivity: the line is straightest where the "
        "last of them has tau {} {}; measure for {}, or leave out more points at the beginning",
        name, best == 0 ? "<=" : ">=", best == 0 ? lowest_tau : highest_tau, best == 0 ? "longer" : "a shorter time"));
  }
  constexpr double golden = 0.6180339887498949;
  double a = low + (best - 1) * step;
  double b = low + (best + 1) * step;
  double inner[2] = {b - golden * (b - a), a + golden * (b - a)};
  double misfit[2] = {line.misfit(inner[0]), line.misfit(inner[1])};
  while (b - a > 1e-9) {
    ++iterations;
    if (misfit[0] < misfit[1]) {
      b = inner[1];
      inner[1] = inner[0];
      misfit[1] = misfit[0];
      inner[0] = b - golden * (b - a);
      misfit[0] = line.misfit(inner[0]);
    } else {
      a = inner[0];
      inner[0] = inner[1];
      misfit[0] = misfit[1];
      inner[1] = a + golden * (b - a);
      misfit[1] = line.misfit(inner[1]);
    }
  }
  return 0.5 * (a + b);
}

/// That D is known at all points that are used.
void check_cutoff(const Line& line, double diffusivity, const TpsSetup& setup, const SourceFunction& source,
                  const std::string& name) {
  const double first_tau = std::sqrt(diffusivity * line.time()[0]) / setup.radius;
  if (first_tau >= source.least_tau()) return;
  throw DeckError(fmt::format(
      "{}: the first of the points that are used has tau = {:.3g}, below \"cutoff\" = {} of [sensor]; leave out more "
      "points at the beginning, or begin the integral earlier",
      name, first_tau, source.least_tau()));
}

/// value exp(+- t s) for the standard deviation s of the logarithm.
Estimate estimate(double value, double log_variance, double t) {
  const double deviation = std::sqrt(log_variance);
  return {value, value * deviation, value * std::exp(-t * deviation), value * std::exp(t * deviation)};
}

void check(const Transient& transient, const TpsSetup& setup, const std::string& name) {
  if (used(transient.time, setup).size() >= min_fit_points) return;
  throw DeckError(fmt::format("{}: {} points after time 0, of which {} are left out; at least {} must remain", name,
                              transient.time.size(), setup.first + setup.last, min_fit_points));
}

}  // namespace

std::span<const double> used(const std::vector<double>& values, const TpsSetup& setup) {
  const std::size_t end = values.size() - std::min(values.size(), setup.last);
  return std::span(values).first(end).subspan(std::min(end, setup.first));
}

TpsFit fit_transient(const Transient& transient, const TpsSetup& setup, const SourceFunction& source,
                     const std::string& name) {
  check(transient, setup, name);
  const Line line(transient, setup, source);
  TpsFit fit;
  const double log_diffusivity = best_log_diffusivity(line, setup, name, fit.iterations);
  Eigen::MatrixX3d columns = line.columns(log_diffusivity);
  const Eigen::Vector2d coefficients = line.line(columns);
  fit.intercept = coefficients[0];
  fit.slope = coefficients[1];
  if (!(fit.slope > 0.0)) throw DeckError(fmt::format("{}: the temperature does not rise with time", name));
  check_cutoff(line, std::exp(log_diffusivity), setup, source, name);
  const Eigen::VectorXd residual = line.residual(columns);
  fit.source.assign(columns.col(1).begin(), columns.col(1).end());
  fit.residual.assign(residual.begin(), residual.end());
  fit.mean_deviation = std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()));
  fit.straightness = residual.squaredNorm() / (line.rise().array() - line.rise().mean()).square().sum();

  // Covariance of intercept, slope and ln(alpha) in the linearised model (T.6).
  columns.col(2) *= fit.slope;
  const double degrees = static_cast<double>(residual.size()) - 3.0;
  const Eigen::Matrix3d covariance =
      residual.squaredNorm() / degrees * (columns.transpose() * columns).inverse().eval();
  const double slope_variance = covariance(1, 1) / (fit.slope * fit.slope);
  const double power = setup.power_deviation * setup.power_deviation;
  const double radius = setup.radius_deviation * setup.radius_deviation;
  const double t = student_quantile(0.975, degrees);
  const double conductivity = setup.power / (pi * std::sqrt(pi) * setup.radius * fit.slope);  // (5.3) with pi^(3/2)
  const double diffusivity = std::exp(log_diffusivity);
  fit.conductivity = estimate(conductivity, slope_variance + power + radius, t);  // (T.7)
  fit.diffusivity = estimate(diffusivity, covariance(2, 2) + 4.0 * radius, t);
  fit.volumetric_heat =
      estimate(conductivity / diffusivity,
               slope_variance + covariance(2, 2) + 2.0 * covariance(1, 2) / fit.slope + power + 9.0 * radius, t);
  const double end = line.time()[line.time().size() - 1];
  fit.characteristic = end * diffusivity / (setup.radius * setup.radius);
  for (const Estimate& e : {fit.conductivity, fit.diffusivity, fit.volumetric_heat}) {
    if (!std::isfinite(e.low) || !std::isfinite(e.high) || !(e.value > 0.0)) {
      throw DeckError(
          fmt::format("{}: the points give no finite figures: they leave slope and diffusivity undetermined, "
                      "or are beyond the range of double precision",
                      name));
    }
  }
  return fit;
}

}  // namespace repose::thermal
