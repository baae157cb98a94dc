#include "calibration/misfit.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "calibration/normal_equivalent.h"

namespace repose {
namespace {

// Standardised. Of a laboratory and a surface without any error; below it T would be made of rounding.
constexpr double least_variance = 1e-12;

void check(std::size_t runs, std::span<const ObservableData> observables) {
  if (observables.empty()) throw DeckError("there is no observable to calibrate with");
  for (const ObservableData& o : observables) {
    if (o.values.size() != runs) {
      throw DeckError(fmt::format("observable \"{}\": has {} values for {} runs", o.name, o.values.size(), runs));
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
    : ranges_(std::move(ranges)) {
  check(runs.size(), observables);
  runs_ = to_box(ranges_, runs);
  for (const ObservableData& o : observables) {
    const ResponseSurface& surface = surfaces_.emplace_back(o.name, o.transform, runs_, o.values);
    const double level = surface.scaled_level(o.laboratory.value);
    if (!std::isfinite(level)) {
      throw DeckError(fmt::format("observable \"{}\": its transform does not take the laboratory value {:g}", o.name,
                                  o.laboratory.value));
    }
    const double error = surface.scaled_deviation(level, o.laboratory.standard_error());
    targets_.push_back({.level = level, .variance = error * error, .freedom = o.laboratory.freedom});
  }
  for (std::size_t a = 0; a < surfaces_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      shared_.push_back(shared_noise(surfaces_[a].process().data(), surfaces_[b].process().data()));
    }
  }
}

Misfit::Look Misfit::look(const Vector& point) const {
  Look result = {.differences = Vector(observables()), .covariance = Matrix::Zero(observables(), observables())};
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    const SurfaceValue surface = surfaces_[k].process().at(point);
    result.differences[i] = surface.mean - targets_[k].level;
    result.covariance(i, i) = targets_[k].variance + surface.deviation * surface.deviation + least_variance;  // (C.11)
  }
  const SharedNoise* shared = shared_.data();
  for (std::size_t a = 0; a < surfaces_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b, ++shared) {
      if (shared->correlation == 0.0) continue;
      const GaussianProcess& pa = surfaces_[a].process();
      const GaussianProcess& pb = surfaces_[b].process();
      const auto i = static_cast<Index>(a);
      const auto j = static_cast<Index>(b);
      result.covariance(i, j) = result.covariance(j, i) =
          shared->covariance(pa.weights(point), pa.noise_variance(), pb.weights(point), pb.noise_variance());
    }
  }
  return result;
}

Matrix Misfit::slopes(const Vector& point) const {
  Matrix result(observables(), parameters());
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    result.row(static_cast<Index>(k)) = surfaces_[k].process().gradient(point).transpose();
  }
  return result;
}

Vector Misfit::residuals(const Vector& point) const {
  const auto [differences, scatter] = look(point);
  const Vector deviation = scatter.diagonal().cwiseSqrt();
  Vector z = differences.cwiseQuotient(deviation);
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    // Welch and Satterthwaite's degrees of freedom of a sum of two variances.
    const double laboratory = targets_[k].variance;
    const double surface = scatter(i, i) - laboratory;
    const double doubt =
        laboratory * laboratory / targets_[k].freedom + surface * surface / surfaces_[k].process().freedom();
    z[i] = normal_equivalent(z[i], scatter(i, i) * scatter(i, i) / doubt);
  }
  Matrix correlation = deviation.cwiseInverse().asDiagonal() * scatter * deviation.cwiseInverse().asDiagonal();
  Eigen::LLT<Matrix> factor(correlation);
  // Correlations from different runs need not fit together; weaker ones always do.
  while (factor.info() != Eigen::Success) {
    correlation *= 0.5;
    correlation.diagonal().setOnes();
    factor.compute(correlation);
  }
  return factor.matrixL().solve(z);  // (C.13)
}

}  // namespace repose
