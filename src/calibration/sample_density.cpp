#include "calibration/sample_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/philox.h"

namespace repose {
namespace {

constexpr double least_power = 1e-9;      // that the power of the likelihood grows by
constexpr double least_effective = 0.5;   // of the walkers, when it grows
constexpr double jump_share = 0.1;        // of the moves go from one maximum to another: by a whole difference
constexpr double least_move = 1e-6;       // of the box: walkers that have met must part
constexpr std::uint32_t numbers_of = 16;  // that a walker draws for a move, at most

/// Random numbers of one walker for one move.
class Numbers {
 public:
  Numbers(std::uint64_t seed, Index walker, std::uint32_t move)
      : seed_(seed), walker_(static_cast<std::uint64_t>(walker)), next_(move * numbers_of) {}
  double operator()() { return uniform(seed_, walker_, RandomStream::posterior, next_++); }
  Index below(Index count) { return static_cast<Index>((*this)() * static_cast<double>(count)); }

 private:
  std::uint64_t seed_;
  std::uint64_t walker_;
  std::uint32_t next_;
};

struct Walkers {
  Matrix points;
  Vector log_prior;
  Vector log_likelihood;

  Index size() const { return points.rows(); }
};

Walkers drawn(const BoxDensity& density, Index dimensions, const SamplePlan& plan) {
  Walkers w = {Matrix(plan.walkers, dimensions), Vector(plan.walkers), Vector(plan.walkers)};
  for (Index i = 0; i < plan.walkers; ++i) {
    Numbers numbers(plan.seed, i, 0);
    Vector shares(dimensions);
    for (double& share : shares) share = numbers();
    const Vector point = density.draw(shares);
    w.points.row(i) = point.transpose();
    w.log_prior[i] = density.log_prior(point);
    w.log_likelihood[i] = density.log_likelihood(point);
  }
  if (!(w.log_likelihood.maxCoeff() > -std::numeric_limits<double>::infinity())) {
    throw DeckError("no parameters drawn of their priors have any likelihood");
  }
  return w;
}

/// Weights of the walkers when the power of the likelihood grows by so much.
Vector weights_of(const Walkers& w, double growth) {
  return (growth * (w.log_likelihood.array() - w.log_likelihood.maxCoeff())).exp();
}

double effective_number(const Vector& weights) {
  const double sum = weights.sum();
  return sum * sum / weights.squaredNorm();
}

/// By how much the power may grow so that half of the walkers still count, or to 1.
double growth_of(const Walkers& w, double power) {
  const double least = least_effective * static_cast<double>(w.size());
  double upper = 1.0 - power;
  if (effective_number(weights_of(w, upper)) >= least) return upper;
  double lower = 0.0;
  for (int k = 0; k < 60 && upper - lower > 1e-6 * upper; ++k) {
    const double middle = 0.5 * (lower + upper);
    (effective_number(weights_of(w, middle)) >= least ? lower : upper) = middle;
  }
  return std::max(lower, std::min(least_power, 1.0 - power));
}

/// Each walker as often as its weight says, within 1.
void resample(Walkers& w, const Vector& weights, double offset) {
  std::vector<Index> from;
  const double each = weights.sum() / static_cast<double>(w.size());
  double sum = 0.0;
  for (Index i = 0; i < w.size(); ++i) {
    sum += weights[i];
    while (static_cast<Index>(from.size()) < w.size() && (static_cast<double>(from.size()) + offset) * each < sum) {
      from.push_back(i);
    }
  }
  while (static_cast<Index>(from.size()) < w.size()) from.push_back(from.back());  // by rounding
  w = {w.points(from, Eigen::all), w.log_prior(from), w.log_likelihood(from)};
}

/// Moves all walkers of one half by differences of the other. Returns how many moved.
Index move_half(const BoxDensity& density, Walkers& w, Index begin, Index end, double power, std::uint64_t seed,
                std::uint32_t move) {
  const Index d = w.points.cols();
  const Index others = begin == 0 ? end : 0;
  const Index count = w.size() - (end - begin);
  const double usual = 2.38 / std::sqrt(2.0 * static_cast<double>(d));  // ter Braak's
  Index moved = 0;
  for (Index i = begin; i < end; ++i) {
    Numbers numbers(seed, i, move);
    const Index a = numbers.below(count);
    const Index b = (a + 1 + numbers.below(count - 1)) % count;
    const double factor = numbers() < jump_share ? 1.0 : usual * (0.25 + numbers());
    Vector point = (w.points.row(i) + factor * (w.points.row(others + a) - w.points.row(others + b))).transpose();
    for (double& x : point) x += least_move * (2.0 * numbers() - 1.0);
    const double threshold = std::log(1.0 - numbers());
    if ((point.array() < 0.0).any() || (point.array() > 1.0).any()) continue;
    const double prior = density.log_prior(point);
    if (prior == -std::numeric_limits<double>::infinity()) continue;
    const double likelihood = density.log_likelihood(point);
    if (!(threshold < prior - w.log_prior[i] + power * (likelihood - w.log_likelihood[i]))) continue;
    w.points.row(i) = point.transpose();
    w.log_prior[i] = prior;
    w.log_likelihood[i] = likelihood;
    ++moved;
  }
  return moved;
}

}  // namespace

Samples sample_density(const BoxDensity& density, Index dimensions, const SamplePlan& plan) {
  Walkers w = drawn(density, dimensions, plan);
  std::uint32_t moves = 0;
  Index moved = 0;
  const auto move = [&](Index times, double power) {
    for (Index k = 0; k < times; ++k) {
      ++moves;
      const Index half = w.size() / 2;
      moved += move_half(density, w, 0, half, power, plan.seed, moves);
      moved += move_half(density, w, half, w.size(), power, plan.seed, moves);
    }
  };
  Samples result;
  for (double power = 0.0; power < 1.0; ++result.stages) {
    const double growth = growth_of(w, power);
    const auto offset_of = static_cast<std::uint32_t>(result.stages);
    resample(w, weights_of(w, growth), uniform(plan.seed, ~std::uint64_t{0}, RandomStream::posterior, offset_of));
    power = growth >= 1.0 - power ? 1.0 : power + growth;
    move(plan.moves, power);
  }
  moved = 0;
  const std::uint32_t before = moves;
  move(plan.settling, 1.0);
  result.points.resize(plan.kept * w.size(), dimensions);
  result.log_density.resize(plan.kept * w.size());
  for (Index k = 0; k < plan.kept; ++k) {
    if (k > 0) move(plan.apart, 1.0);
    result.points.middleRows(k * w.size(), w.size()) = w.points;
    result.log_density.segment(k * w.size(), w.size()) = w.log_prior + w.log_likelihood;
  }
  result.acceptance =
      static_cast<double>(moved) / (static_cast<double>(moves - before) * static_cast<double>(w.size()));
  return result;
}

}  // namespace repose
