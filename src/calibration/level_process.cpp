#include "calibration/level_process.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration/level_likelihood.h"

namespace repose {
namespace {

constexpr Index no_column = -1;

/// The first row of each level in the vector of all points, and behind the last their number.
std::vector<Index> first_rows(const std::vector<Replicates>& levels) {
  std::vector<Index> rows = {0};
  for (const Replicates& level : levels) rows.push_back(rows.back() + level.size());
  return rows;
}

}  // namespace

LevelProcess::LevelProcess(std::vector<Replicates> levels) {
  for (Replicates& level : levels) {
    BelowLevel below;
    if (!data_.empty()) {
      below_.push_back(std::make_shared<LevelProcess>(*this));
      const std::size_t k = data_.size() - 1;
      below.mean.resize(level.size());
      for (Index i = 0; i < level.size(); ++i) below.mean[i] = mean(level.points.row(i).transpose());
      below.covariance = covariance(k, level.points, k, level.points);
      below.noise = parameters_[k].noise;
    }
    const LevelParameters parameters = most_likely_level(level, below);
    add_level(std::move(level), parameters);
  }
}

LevelProcess::LevelProcess(std::vector<Replicates> levels, std::vector<LevelParameters> parameters) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (k > 0) below_.push_back(std::make_shared<LevelProcess>(*this));
    add_level(std::move(levels[k]), parameters[k]);
  }
}

void LevelProcess::add_level(Replicates data, const LevelParameters& parameters) {
  const bool is_lowest = data_.empty();
  linear_.push_back(has_plane(data, is_lowest) ? 1 : 0);
  rho_column_.push_back(is_lowest ? no_column : columns_);
  columns_ += (is_lowest ? 0 : 1) + 1 + (linear_.back() != 0 ? data.points.cols() : 0);
  data_.push_back(std::move(data));
  parameters_.push_back(parameters);
  factorise();
}

void LevelProcess::factorise() {
  const std::vector<Index> rows = first_rows(data_);
  const Index n = rows.back();
  Matrix covariance(n, n);
  Matrix all_terms(n, columns_);
  Vector values(n);
  for (std::size_t k = 0; k < levels(); ++k) {
    const Replicates& d = data_[k];
    covariance.middleRows(rows[k], d.size()) = prior_with_data(k, d.points);  // (C.26)
    all_terms.middleRows(rows[k], d.size()) = terms(k, d.points);
    values.segment(rows[k], d.size()) = d.mean;
    for (Index i = 0; i < d.size(); ++i) {
      covariance(rows[k] + i, rows[k] + i) += parameters_[k].noise_variance(d.points.row(i).transpose()) / d.count[i];
    }
  }
  covariance_.compute(covariance);
  weighted_terms_ = covariance_.solve(all_terms);
  Matrix information = all_terms.transpose() * weighted_terms_;
  Vector right = weighted_terms_.transpose() * values;
  for (std::size_t k = 1; k < levels(); ++k) {  // the coefficient is rho's difference from the one that is held
    const double weight = 1.0 / (rho_scatter * rho_scatter);
    information(rho_column_[k], rho_column_[k]) += weight;
    right[rho_column_[k]] -= weight * parameters_[k].rho;
  }
  coefficient_covariance_ = information.llt().solve(Matrix::Identity(columns_, columns_));
  coefficients_ = coefficient_covariance_ * right;
  weights_ = covariance_.solve(values - all_terms * coefficients_);
  const Replicates& last = data_.back();
  const Index own = columns_ - (levels() > 1 ? rho_column_.back() : 0);
  // What a level adds has a variance of its own, of which the seeds within the points say nothing.
  freedom_ = std::max(1.0, static_cast<double>(last.size() - own));
}

double LevelProcess::share(std::size_t added, std::size_t of) const {
  double product = 1.0;
  for (std::size_t k = added + 1; k <= of; ++k) product *= parameters_[k].rho;
  return product;
}

Matrix LevelProcess::prior(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const {
  Matrix result = Matrix::Zero(a.rows(), b.rows());
  for (std::size_t m = 0; m <= std::min(level_a, level_b); ++m) {
    const double variance = share(m, level_a) * share(m, level_b) * parameters_[m].added_variance;
    result += variance * MaternKernel{parameters_[m].lengths}.between(a, b);
  }
  return result;
}

Matrix LevelProcess::prior_with_data(std::size_t level, const Matrix& a) const {
  const std::vector<Index> rows = first_rows(data_);
  Matrix result(a.rows(), rows.back());
  for (std::size_t k = 0; k < levels(); ++k) {
    result.middleCols(rows[k], data_[k].size()) = prior(level, a, k, data_[k].points);
  }
  return result;
}

Matrix LevelProcess::terms(std::size_t level, const Matrix& points) const {
  Matrix result = Matrix::Zero(points.rows(), columns_);
  Index column = 0;
  for (std::size_t m = 0; m <= level; ++m) {
    if (m > 0) {
      const LevelProcess& below = *below_[m - 1];
      for (Index i = 0; i < points.rows(); ++i) {
        result(i, column) = share(m, level) * below.mean(points.row(i).transpose());
      }
      ++column;
    }
    const Matrix own = mean_terms(points, linear_[m] != 0);
    result.middleCols(column, own.cols()) = share(m, level) * own;
    column += own.cols();
  }
  return result;
}

double LevelProcess::prior_variance() const {
  double sum = 0.0;
  for (std::size_t m = 0; m < levels(); ++m) {
    sum += share(m, levels() - 1) * share(m, levels() - 1) * parameters_[m].added_variance;
  }
  return sum;
}

double LevelProcess::mean(const Vector& point) const {
  const std::size_t last = levels() - 1;
  return terms(last, point.transpose()).row(0).dot(coefficients_) +
         prior_with_data(last, point.transpose()).row(0).dot(weights_);
}

SurfaceValue LevelProcess::at(const Vector& point) const {
  const std::size_t last = levels() - 1;
  const Vector near = prior_with_data(last, point.transpose()).transpose();
  const Vector own = terms(last, point.transpose()).transpose();
  const Vector excess = own - weighted_terms_.transpose() * near;
  double variance =
      prior_variance() - covariance_.matrixL().solve(near).squaredNorm() + excess.dot(coefficient_covariance_ * excess);
  for (std::size_t k = 1; k <= last; ++k) {  // rho and the level below are both uncertain
    const double off = share(k, last) * rho_deviation(k) * below_[k - 1]->at(point).deviation;
    variance += off * off;
  }
  return {.mean = own.dot(coefficients_) + near.dot(weights_), .deviation = std::sqrt(std::max(0.0, variance))};
}

double LevelProcess::freedom(const Vector& point) const {
  if (levels() == 1) return freedom_;
  const double deviation = at(point).deviation;
  const LevelProcess& below = *below_.back();
  const double from_below = std::min(std::fabs(parameters_.back().rho) * below.at(point).deviation, deviation);
  const auto square = [](double x) { return x * x; };
  const double variance = square(deviation), known = square(from_below);
  return square(variance) / (square(known) / below.freedom(point) + square(variance - known) / freedom_);
}

std::vector<Vector> LevelProcess::weights(const Vector& point) const {
  const std::size_t last = levels() - 1;
  const Vector near = prior_with_data(last, point.transpose()).transpose();
  const Vector excess = terms(last, point.transpose()).transpose() - weighted_terms_.transpose() * near;
  const Vector all = covariance_.solve(near) + weighted_terms_ * (coefficient_covariance_ * excess);
  const std::vector<Index> rows = first_rows(data_);
  std::vector<Vector> result;
  for (std::size_t k = 0; k < levels(); ++k) result.emplace_back(all.segment(rows[k], data_[k].size()));
  return result;
}

Matrix LevelProcess::covariance(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const {
  const Matrix near_a = prior_with_data(level_a, a).transpose();
  const Matrix near_b = prior_with_data(level_b, b).transpose();
  const Matrix excess_a = terms(level_a, a).transpose() - weighted_terms_.transpose() * near_a;
  const Matrix excess_b = terms(level_b, b).transpose() - weighted_terms_.transpose() * near_b;
  return prior(level_a, a, level_b, b) - near_a.transpose() * covariance_.solve(near_b) +
         excess_a.transpose() * coefficient_covariance_ * excess_b;
}

double LevelProcess::rho_deviation(std::size_t level) const {
  return std::sqrt(coefficient_covariance_(rho_column_[level], rho_column_[level]));
}

}  // namespace repose
