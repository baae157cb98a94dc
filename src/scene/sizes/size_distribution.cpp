#include "scene/sizes/size_distribution.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "scene/sizes/size_csv.h"

namespace repose {
namespace {

constexpr int resolution = 2000;  // bins of a continuous distribution

double cube(double x) { return x * x * x; }

// Means over a bin whose share is spread evenly over the diameter.
double mean_cube(const SizeBin& b) { return 0.25 * (b.low + b.high) * (b.low * b.low + b.high * b.high); }
double mean_inverse_cube(const SizeBin& b) {
  return b.low == b.high ? 1.0 / cube(b.low) : 0.5 * (b.low + b.high) / (b.low * b.low * b.high * b.high);
}

/// Running sums, divided by the last.
std::vector<double> cumulated(std::vector<double> values) {
  for (std::size_t k = 1; k < values.size(); ++k) values[k] += values[k - 1];
  const double total = values.back();
  for (double& value : values) value /= total;
  return values;
}

struct Found {
  std::size_t bin;
  double inside;  // share of the bin below, 0 to 1
};

Found find(const std::vector<double>& cumulative, double u) {
  const auto end = std::upper_bound(cumulative.begin(), cumulative.end() - 1, u);
  const auto bin = static_cast<std::size_t>(end - cumulative.begin());
  const double below = bin == 0 ? 0.0 : cumulative[bin - 1];
  const double share = cumulative[bin] - below;
  if (share == 0.0) return {bin, 1.0};  // beside a very large one it has been lost to rounding
  return {bin, std::clamp((u - below) / share, 0.0, 1.0)};
}

/// Edges that divide [low, high] evenly on a logarithmic scale.
std::vector<double> logarithmic_edges(double low, double high) {
  std::vector<double> edges;
  const double step = log_reproducible(high / low) / resolution;
  for (int k = 0; k < resolution; ++k) edges.push_back(low * exp_reproducible(k * step));
  edges.push_back(high);
  return edges;
}

/// The bins of a density (per m, of any scale) between two diameters, each by Simpson's rule.
template <class Density>
std::vector<SizeBin> bins_of(double low, double high, const Density& density) {
  std::vector<SizeBin> bins;
  const std::vector<double> edges = logarithmic_edges(low, high);
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double a = edges[k];
    const double b = edges[k + 1];
    bins.push_back({a, b, (b - a) / 6.0 * (density(a) + 4.0 * density(0.5 * (a + b)) + density(b))});
  }
  return bins;
}

/// e^x, zero where it would underflow.
double exp_of(double x) { return x < -700.0 ? 0.0 : exp_reproducible(x); }

std::vector<SizeBin> lognormal_bins(const SizesDeck& s) {
  const double deviation = log_reproducible(s.geometric_deviation);
  return bins_of(s.min_diameter, s.max_diameter, [&](double d) {
    const double z = log_reproducible(d / s.median) / deviation;
    return exp_of(-0.5 * z * z) / d;
  });
}

std::vector<SizeBin> weibull_bins(const SizesDeck& s) {
  return bins_of(s.min_diameter, s.max_diameter, [&](double d) {
    const double log_x = log_reproducible(d / s.scale);
    const double power = s.shape * log_x > 700.0 ? 1e300 : exp_of(s.shape * log_x);  // (d / scale)^shape
    return exp_of((s.shape - 1.0) * log_x - std::fmin(power, 1e4));
  });
}

std::vector<SizeBin> class_bins(const SizesDeck& s) {
  std::vector<SizeBin> bins;
  for (std::size_t k = 0; k < s.diameters.size(); ++k) bins.push_back({s.diameters[k], s.diameters[k], s.shares[k]});
  return bins;
}

/// What lies between two diameters; NaN leaves an end open.
std::vector<SizeBin> truncated(std::vector<SizeBin> bins, double min, double max) {
  for (SizeBin& b : bins) {
    const double low = std::fmax(b.low, min);  // fmax and fmin take the other one for NaN
    const double high = std::fmin(b.high, max);
    if (b.high > b.low) b.share *= std::fmax(0.0, high - low) / (b.high - b.low);
    b.low = low;
    b.high = high;
  }
  return bins;
}

SizeDistribution from_csv(const SizesDeck& sizes, const ReadFile& read_file) {
  const SizeAnalysis analysis = parse_size_csv(read_file(sizes.file), sizes.file);
  const std::vector<SizeBin> bins = truncated(analysis.bins, sizes.min_diameter, sizes.max_diameter);
  if (std::all_of(bins.begin(), bins.end(), [](const SizeBin& b) { return b.share == 0.0; })) {
    throw DeckError(
        fmt::format("{}: nothing lies between min_diameter and max_diameter; the file goes from {} m to {} m",
                    sizes.file, analysis.bins.front().low, analysis.bins.back().high));
  }
  return {analysis.by, bins};
}

}  // namespace

SizeDistribution::SizeDistribution(Weighting by, const std::vector<SizeBin>& bins) : by_(by) {
  std::copy_if(bins.begin(), bins.end(), std::back_inserter(bins_), [](const SizeBin& b) { return b.share > 0.0; });
  const bool by_mass = by == Weighting::mass;
  double total = 0.0;
  double diameters = 0.0;
  double cubes = 0.0;
  for (const SizeBin& b : bins_) {
    const double number = by_mass ? b.share * mean_inverse_cube(b) : b.share;
    const double mass = by_mass ? b.share : b.share * mean_cube(b);
    number_.push_back(number);
    mass_.push_back(mass);
    total += number;
    cubes += mass;
    diameters += number * (by_mass ? 2.0 * b.low * b.high / (b.low + b.high) : 0.5 * (b.low + b.high));
  }
  mean_ = diameters / total;
  volume_ = pi / 6.0 * cubes / total;
  number_ = cumulated(number_);
  mass_ = cumulated(mass_);
}

double SizeDistribution::quantile(double u) const {
  const auto [bin, inside] = find(number_, u);
  const auto& [low, high, share] = bins_[bin];
  if (low == high) return low;
  if (by_ == Weighting::number) return std::min(low + inside * (high - low), high);
  const double a = 1.0 / (low * low);  // the number goes as d^-3 where the mass is even
  const double b = 1.0 / (high * high);
  return std::clamp(1.0 / std::sqrt(a - inside * (a - b)), low, high);
}

double SizeDistribution::mass_quantile(double u) const {
  const auto [bin, inside] = find(mass_, u);
  const auto& [low, high, share] = bins_[bin];
  if (low == high) return low;
  if (by_ == Weighting::mass) return std::min(low + inside * (high - low), high);
  const double a = low * low * low * low;  // the mass goes as d^3 where the number is even
  const double b = high * high * high * high;
  return std::clamp(std::sqrt(std::sqrt(a + inside * (b - a))), low, high);
}

bool SizeDistribution::is_discrete() const {
  return std::all_of(bins_.begin(), bins_.end(), [](const SizeBin& b) { return b.low == b.high; });
}

std::vector<double> SizeDistribution::mass_shares() const {
  std::vector<double> shares = mass_;
  for (std::size_t k = shares.size(); --k > 0;) shares[k] -= shares[k - 1];
  return shares;
}

SizeDistribution make_size_distribution(const ParticlesDeck& particles, const ReadFile& read_file,
                                        const std::string& block) {
  const SizesDeck& s = particles.sizes;
  if (!s.enabled) return {Weighting::number, {{particles.diameter, particles.diameter, 1.0}}};
  if (s.type == SizesType::csv) return from_csv(s, read_file);
  const std::vector<SizeBin> bins = s.type == SizesType::classes     ? class_bins(s)
                                    : s.type == SizesType::lognormal ? lognormal_bins(s)
                                    : s.type == SizesType::weibull
                                        ? weibull_bins(s)
                                        : std::vector<SizeBin>{{s.min_diameter, s.max_diameter, 1.0}};
  if (std::none_of(bins.begin(), bins.end(), [](const SizeBin& b) { return b.share > 0.0; })) {
    throw DeckError(fmt::format("{}: nothing of the distribution lies between min_diameter and max_diameter", block));
  }
  return {s.by, bins};
}

}  // namespace repose
