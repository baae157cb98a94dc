#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "calibration/misfit.h"

namespace repose {

/// Two observables over two parameters that look like those of the thesis, in place of simulations.
struct StandIn {
  using Response = double (*)(double a, double b);

  std::vector<ParameterRange> ranges;
  Response response[2];
  Transform transform;
  double seed_scatter[2];          ///< of one run; counts: how many times as great as Poisson's
  double laboratory_deviation[2];  ///< counts: over the count
  double repeats;
};

inline double rise(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// Discharged mass (g) and angle of repose (degrees) over sliding and rolling friction (thesis, figures 3.11, 3.12):
/// rolling friction acts where sliding friction is high, and the mass hardly knows sliding friction there.
inline StandIn friction_stand_in() {
  return {.ranges = {{"sliding", 0.1, 0.9}, {"rolling", 0.1, 0.5}},
          .response = {[](double mu, double mu_r) {
                         return 23.0 - 0.8 * std::tanh(mu / 0.2) - 1.8 * mu_r * rise((mu - 0.35) / 0.12) - 0.15 * mu;
                       },
                       [](double mu, double mu_r) {
                         return 16.0 + 9.0 * std::tanh(mu / 0.25) + 12.0 * mu_r * rise((mu - 0.3) / 0.15) + 7.0 * mu;
                       }},
          .transform = Transform::none,
          .seed_scatter = {0.03, 0.5},
          .laboratory_deviation = {0.02, 0.65},
          .repeats = 10.0};
}

/// Counts of grains in areas 1 and 3 over the restitution between grains and at the wall (figures 3.23, 3.25).
inline StandIn counts_stand_in() {
  return {.ranges = {{"grains", 0.1, 0.9}, {"wall", 0.1, 0.9}},
          .response = {[](double e, double w) { return 180.0 + 1500.0 * std::pow(e, 4.0) * (1.0 + 0.1 * w); },
                       [](double e, double w) { return 6.0 + 260.0 * e * e * std::pow(w, 1.5) + 30.0 * e; }},
          .transform = Transform::square_root,
          .seed_scatter = {1.0, 1.0},
          .laboratory_deviation = {0.12, 0.11},
          .repeats = 8.0};
}

/// Numbers from a seed; those of the standard's engine are the same everywhere, its distributions are the library's.
struct Draw {
  std::mt19937_64 engine;
  explicit Draw(std::uint64_t seed) : engine(seed) {}
  double normal() { return std::normal_distribution<double>()(engine); }
  double between(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(engine); }
  double poisson(double mean) { return std::poisson_distribution<int>(mean)(engine); }
};

/// What one run at a point gives. `common` is what its seed does to both observables.
inline std::vector<double> run_of(const StandIn& s, const std::vector<double>& point, Draw& draw) {
  const double common = draw.normal();
  std::vector<double> values;
  for (int k = 0; k < 2; ++k) {
    const double mean = s.response[k](point[0], point[1]);
    const double own = draw.normal();
    values.push_back(s.transform == Transform::none ? mean + s.seed_scatter[k] * (0.6 * common + 0.8 * own)
                                                    : draw.poisson(mean));
  }
  return values;
}

/// What the laboratory has at the hidden parameters.
inline std::vector<LaboratoryValue> laboratory_of(const StandIn& s, const std::vector<double>& hidden, Draw& draw) {
  std::vector<LaboratoryValue> result;
  for (int k = 0; k < 2; ++k) {
    const double mean = s.response[k](hidden[0], hidden[1]);
    const double deviation = s.laboratory_deviation[k] * (s.transform == Transform::none ? 1.0 : mean);
    result.push_back({.value = mean + deviation / std::sqrt(s.repeats) * draw.normal(),
                      .deviation = deviation,
                      .repeats = s.repeats});
  }
  return result;
}

/// Runs and laboratory as the estimate takes them.
struct Campaign {
  std::vector<std::vector<double>> points;
  std::vector<ObservableData> observables;
};

inline Campaign start_of(const StandIn& s, const std::vector<LaboratoryValue>& laboratory) {
  Campaign c;
  for (std::size_t k = 0; k < 2; ++k) {
    c.observables.push_back(
        {.name = k == 0 ? "first" : "second", .transform = s.transform, .laboratory = laboratory[k], .values = {}});
  }
  return c;
}

inline void add_run(Campaign& c, const StandIn& s, const std::vector<double>& point, Draw& draw) {
  c.points.push_back(point);
  const std::vector<double> values = run_of(s, point, draw);
  for (std::size_t k = 0; k < 2; ++k) c.observables[k].values.push_back(values[k]);
}

/// The runs of a grid of `side` by `side` points.
inline void add_grid(Campaign& c, const StandIn& s, int side, int seeds, Draw& draw) {
  for (int run = 0; run < side * side * seeds; ++run) {
    const double i = run / seeds % side;
    const double j = run / seeds / side;  // whole
    const auto place = [&](const ParameterRange& r, double at) {
      return r.lower + (r.upper - r.lower) * at / (side - 1);
    };
    add_run(c, s, {place(s.ranges[0], i), place(s.ranges[1], j)}, draw);
  }
}

inline std::vector<double> hidden_in(const StandIn& s, Draw& draw) {
  return {draw.between(s.ranges[0].lower, s.ranges[0].upper), draw.between(s.ranges[1].lower, s.ranges[1].upper)};
}

}  // namespace repose
