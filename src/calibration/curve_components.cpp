#include "calibration/curve_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <fmt/core.h>

#include "base/error.h"

namespace repose {
namespace {

constexpr double left_out_most = 0.01;  // of the variance between the points
constexpr double least_share = 1e-7;    // of a component's deviation over the first one's: below it is rounding
constexpr double rounding = 1e-12;      // of curves that are all the same

Matrix correlation_of(const MeasuredCurve& curve) {
  const Index n = curve.x.size();
  Matrix result = Matrix::Identity(n, n);
  for (Index i = 0; i < n && curve.correlation_length > 0.0; ++i) {
    for (Index j = 0; j < i; ++j) {
      result(i, j) = result(j, i) = std::exp((curve.x[j] - curve.x[i]) / curve.correlation_length);
    }
  }
  return result;
}

/// The means of the runs at each point, a column each about the mean of their level.
struct PointMeans {
  Matrix about_level;
  Vector centre;                   ///< of the last level
  double variance_of_seeds = 0.0;  ///< of a mean in the mean, over all x
};

PointMeans point_means(const std::vector<Vector>& curves, std::span<const CurveRun> runs, std::size_t last) {
  using Key = std::pair<std::size_t, std::size_t>;  // level, point
  std::map<Key, std::pair<Vector, double>> sums;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto& [sum, count] =
        sums.try_emplace({runs[i].level, runs[i].point}, Vector::Zero(curves[i].size()), 0.0).first->second;
    sum += curves[i];
    count += 1.0;
  }
  std::map<std::size_t, std::pair<Vector, double>> levels;
  for (auto& [key, mean] : sums) {
    mean.first /= mean.second;
    auto& [sum, count] = levels.try_emplace(key.first, Vector::Zero(mean.first.size()), 0.0).first->second;
    sum += mean.first;
    count += 1.0;
  }
  for (auto& [level, mean] : levels) mean.first /= mean.second;

  PointMeans result;
  result.centre = levels.at(last).first;
  result.about_level.resize(result.centre.size(), static_cast<Index>(sums.size()));
  double of_one = 0.0;  // the mean of 1 / runs at a point
  Index column = 0;
  for (const auto& [key, mean] : sums) {
    result.about_level.col(column++) = mean.first - levels.at(key.first).first;
    of_one += 1.0 / (mean.second * static_cast<double>(sums.size()));
  }
  double squares = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    squares += (curves[i] - sums.at({runs[i].level, runs[i].point}).first).squaredNorm();
  const std::size_t freedom = runs.size() - sums.size();
  if (freedom > 0) result.variance_of_seeds = of_one * squares / static_cast<double>(freedom);
  return result;
}

}  // namespace

CurveComponents::CurveComponents(const std::string& name, MeasuredCurve curve, std::span<const CurveRun> runs,
                                 Index least, Index most)
    : curve_(std::move(curve)), correlation_(correlation_of(curve_)) {
  if (runs.empty()) throw DeckError(fmt::format("observable \"{}\": no run has a curve", name));
  std::vector<Vector> scaled;
  std::size_t last = 0;
  for (const CurveRun& run : runs) {
    scaled.emplace_back(run.y.cwiseQuotient(curve_.deviation));
    last = std::max(last, run.level);
  }
  PointMeans means = point_means(scaled, runs, last);
  centre_ = std::move(means.centre);
  const Eigen::JacobiSVD<Matrix> svd(means.about_level, Eigen::ComputeThinU);  // (K.2)
  const Vector& deviations = svd.singularValues();
  if (!(deviations[0] > rounding * centre_.norm())) {
    throw DeckError(fmt::format("observable \"{}\": the curves of the runs do not differ from point to point", name));
  }
  const Vector variances = deviations.cwiseAbs2() / static_cast<double>(means.about_level.cols());
  const Index there = (deviations.array() > least_share * deviations[0]).count();
  const auto beyond = [&](Index k) { return variances.tail(variances.size() - k).sum(); };
  const double enough = left_out_most * beyond(0) + means.variance_of_seeds;
  Index kept = 0;
  while (kept < std::min(there, most) && (kept < least || beyond(kept) > enough)) ++kept;
  left_out_ = beyond(kept) / beyond(0);

  const Matrix principal = svd.matrixU().leftCols(kept);
  const Matrix error = principal.transpose() * correlation_ * principal;
  const Matrix signal = variances.head(kept).asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(signal, error);  // (K.3)
  const Matrix combinations = solver.eigenvectors().rowwise().reverse();         // the greatest first
  weights_ = principal * combinations;
  shapes_ = principal * error * combinations;
  for (Index k = 0; k < kept; ++k) {  // the sign of a component is free: its greatest value is above 0
    Index at = 0;
    shapes_.col(k).cwiseAbs().maxCoeff(&at);
    if (shapes_(at, k) > 0.0) continue;
    shapes_.col(k) *= -1.0;
    weights_.col(k) *= -1.0;
  }
}

Vector CurveComponents::deviation_of(const Vector& deviation) const {
  const Matrix taken = deviation.cwiseQuotient(curve_.deviation).asDiagonal() * weights_;
  return (taken.transpose() * correlation_ * taken).diagonal().cwiseSqrt();
}

double CurveComponents::laboratory_rest() const {
  const Vector rest = (curve_.y - curve(laboratory())).cwiseQuotient(curve_.deviation);
  return rest.norm() / std::sqrt(static_cast<double>(rest.size()));
}

}  // namespace repose
