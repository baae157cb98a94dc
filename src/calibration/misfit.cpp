#include "calibration/misfit.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "calibration/level_surface.h"
#include "calibration/normal_equivalent.h"
#include "calibration/response_surface.h"

namespace repose {
namespace {

// Standardised. Of a laboratory and a surface without any error; below it T would be made of rounding.
constexpr double rounding = 1e-12;

void check(std::size_t runs, std::span<const ObservableData> observables) {
  if (observables.empty()) throw DeckError("there is no observable to calibrate with");
  for (const ObservableData& o : observables) {
    if (o.values.size() != runs) {
      throw DeckError(fmt::format("observable \"{}\": has {} values for {} runs", o.name, o.values.size(), runs));
    }
    if (!(o.discrepancy >= 0.0) || !std::isfinite(o.discrepancy)) {
      throw DeckError(fmt::format("observable \"{}\": its discrepancy must be 0 or more", o.name));
    }
    const LaboratoryValue& laboratory = o.laboratory;
    if (!std::isfinite(laboratory.value) || !std::isfinite(laboratory.deviation) || !(laboratory.deviation >= 0.0) ||
        !(laboratory.repeats >= 1.0) || !(laboratory.freedom > 0.0)) {
      throw DeckError(
          fmt::format("observable \"{}\": its laboratory value needs a deviation of 0 or more and 1 repeat "
                      "or more",
                      o.name));
    }
  }
}

}  // namespace

Misfit::Misfit(std::vector<ParameterRange> ranges, std::span<const std::vector<double>> runs,
               std::span<const ObservableData> observables)
    : Misfit(std::move(ranges), runs, RunLevels{}, observables) {}

Misfit::Misfit(std::vector<ParameterRange> ranges, std::span<const std::vector<double>> runs, RunLevels levels,
               std::span<const ObservableData> observables)
    : ranges_(std::move(ranges)), levels_(std::move(levels)) {
  check(runs.size(), observables);
  runs_ = to_box(ranges_, runs);
  for (const ObservableData& o : observables) {
    if (levels_.of_run.empty()) {
      surfaces_.push_back(std::make_shared<ResponseSurface>(o.name, o.transform, runs_, o.values));
    } else {
      surfaces_.push_back(std::make_shared<LevelSurface>(o.name, o.transform, runs_, o.values, levels_));
    }
    if (!std::isfinite(surfaces_.back()->level_of(o.laboratory.value, Vector::Constant(parameters(), 0.5)))) {
      throw DeckError(fmt::format("observable \"{}\": its transform does not take the laboratory value {:g}", o.name,
                                  o.laboratory.value));
    }
    laboratory_.push_back(o.laboratory);
    discrepancy_.push_back(o.discrepancy);
    experiment_.push_back(o.experiment);
  }
  share_noise();
}

void Misfit::share_noise() {
  shares_noise_.assign(surfaces_.size(), false);
  for (std::size_t a = 0; a < surfaces_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      std::vector<SharedNoise>& of_levels = shared_.emplace_back();
      for (std::size_t level = 0; level < levels_.count; ++level) {
        of_levels.push_back(shared_noise(surfaces_[a]->data(level), surfaces_[b]->data(level)));
        if (of_levels.back().correlation != 0.0) shares_noise_[a] = shares_noise_[b] = true;
      }
    }
  }
}

Misfit::Target Misfit::target(std::size_t k, const Vector& point) const {
  const ObservableSurface& surface = *surfaces_[k];
  const double level = surface.level_of(laboratory_[k].value, point);
  const double error = surface.deviation_of(level, laboratory_[k].standard_error(), point);
  const double off = surface.deviation_of(level, discrepancy_[k], point);
  return {.level = level, .variance = error * error, .discrepancy = off * off};
}

double Misfit::least_variance(Index k, const Vector& point) const {
  const Target t = target(static_cast<std::size_t>(k), point);
  return t.variance + t.discrepancy;
}

Misfit::Look Misfit::look(const Vector& point) const {
  Look result = {.differences = Vector(observables()), .covariance = Matrix::Zero(observables(), observables())};
  std::vector<std::vector<NoiseWeights>> weights(surfaces_.size());
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    const SurfaceValue surface = shares_noise_[k] ? surfaces_[k]->at(point, weights[k]) : surfaces_[k]->at(point);
    const Target t = target(k, point);
    result.differences[i] = surface.mean - t.level;
    result.covariance(i, i) = t.variance + t.discrepancy + surface.deviation * surface.deviation + rounding;  // (C.11)
  }
  auto shared = shared_.begin();
  for (std::size_t a = 0; a < surfaces_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b, ++shared) {
      double covariance = 0.0;
      for (std::size_t level = 0; level < levels_.count; ++level) {
        if ((*shared)[level].correlation == 0.0) continue;
        const NoiseWeights& wa = weights[a][level];
        const NoiseWeights& wb = weights[b][level];
        covariance += (*shared)[level].covariance(wa.weights, wa.variance, wb.weights, wb.variance);
      }
      result.covariance(static_cast<Index>(a), static_cast<Index>(b)) = covariance;
      result.covariance(static_cast<Index>(b), static_cast<Index>(a)) = covariance;
    }
  }
  return result;
}

Matrix Misfit::slopes(const Vector& point) const {
  Matrix result(observables(), parameters());
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    result.row(static_cast<Index>(k)) = surfaces_[k]->gradient(point).transpose();
  }
  return result;
}

Misfit::Residual Misfit::residual(const Vector& point) const {
  const auto [differences, scatter] = look(point);
  const Vector deviation = scatter.diagonal().cwiseSqrt();
  Vector z = differences.cwiseQuotient(deviation);
  double log_slope = 0.0;
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    // Welch and Satterthwaite's degrees of freedom of a sum of two variances.
    const Target t = target(k, point);
    const double surface = scatter(i, i) - t.variance - t.discrepancy;
    const double doubt =
        t.variance * t.variance / laboratory_[k].freedom + surface * surface / surfaces_[k]->freedom(point);
    const double freedom = scatter(i, i) * scatter(i, i) / doubt;
    log_slope += log_slope_of_normal_equivalent(z[i], freedom) - std::log(deviation[i]);
    z[i] = normal_equivalent(z[i], freedom);
  }
  Matrix correlation = deviation.cwiseInverse().asDiagonal() * scatter * deviation.cwiseInverse().asDiagonal();
  Eigen::LLT<Matrix> factor(correlation);
  // Correlations from different runs need not fit together; weaker ones always do.
  while (factor.info() != Eigen::Success) {
    correlation *= 0.5;
    correlation.diagonal().setOnes();
    factor.compute(correlation);
  }
  log_slope -= factor.matrixLLT().diagonal().array().log().sum();
  return {factor.matrixL().solve(z), log_slope};  // (C.13)
}

Vector Misfit::residuals(const Vector& point) const { return residual(point).values; }

double Misfit::log_likelihood(const Vector& point) const {
  const auto [z, log_slope] = residual(point);
  return log_slope - 0.5 * z.squaredNorm();
}

}  // namespace repose
