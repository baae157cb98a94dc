#include "photo/plate_tally.h"

#include "base/math.h"
#include "measurement/scattering.h"

namespace repose::photo {
namespace {

using Kind = GrainPatches::Kind;

/// The share of each ring about the axis that grains cover, from `width` (m) to its multiples; behind the last one with
/// grains comes an empty one. `grain` is the area in m^2 that each patch of a grain stands for.
std::vector<double> coverage(const GrainPatches& grains, const Frame& frame, double width, double grain) {
  std::vector<double> covered;
  const auto add = [&](double x, double y, double area) {
    if (!frame.holds(x, y)) return;
    const auto ring = static_cast<std::size_t>(frame.distance(x, y) / width);
    if (covered.size() < ring + 2) covered.resize(ring + 2);
    covered[ring] += area;
  };
  const Patches& patches = grains.patches;
  for (std::size_t y = 0; y * patches.width < patches.label.size(); ++y) {
    for (std::size_t x = 0; x < patches.width; ++x) {
      const std::int32_t patch = patches.at(x, y);
      if (patch < 0) continue;
      const Kind kind = grains.kind[static_cast<std::size_t>(patch)];
      if (kind != Kind::clump && kind != Kind::pile) continue;
      add(static_cast<double>(x), static_cast<double>(y), grain / grains.grain_area);
    }
  }
  for (std::size_t i = 0; i < grains.kind.size(); ++i) {
    if (grains.kind[i] == Kind::single) add(patches.all[i].x, patches.all[i].y, grain);
  }
  for (std::size_t k = 0; k < covered.size(); ++k)
    covered[k] /= pi * width * width * (2.0 * static_cast<double>(k) + 1.0);
  return covered;
}

std::optional<double> base_of(const GrainPatches& grains, const Frame& frame, const PhotoDeck& deck,
                              const ScatteringDeck& scattering) {
  if (grains.pile < 0) return {};
  const double given = deck.plate.grain_diameter;
  const double diameter = std::isnan(given) ? seen_diameter(grains, frame.scale) : given;
  const double width = std::isnan(scattering.ring_width) ? 2.0 * diameter : scattering.ring_width;
  return end_of_dense_part(coverage(grains, frame, width, pi / 4.0 * diameter * diameter), width,
                           scattering.base_share * deck.plate.layer_coverage);
}

/// The places of single grains and of those in clumps and at the pile's foot.
std::vector<Pixel> places(const GrainPatches& grains, const std::vector<GrainPeak>& peaks) {
  std::vector<Pixel> result;
  for (std::size_t i = 0; i < grains.kind.size(); ++i) {
    if (grains.kind[i] == Kind::single) result.push_back({grains.patches.all[i].x, grains.patches.all[i].y});
  }
  for (const GrainPeak& peak : peaks) result.push_back(peak.at);
  return result;
}

std::vector<double> counts(const std::vector<Pixel>& places, const Frame& frame, const std::vector<Bounds>& bounds) {
  std::vector<double> result(bounds.size(), 0.0);
  for (const Pixel& p : places) {
    if (!frame.holds(p.x, p.y)) continue;
    const double distance = frame.distance(p.x, p.y);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (distance >= bounds[i].from && distance < bounds[i].to) result[i] += 1.0;
    }
  }
  return result;
}

}  // namespace

double seen_diameter(const GrainPatches& grains, double scale) {
  return 2.0 * std::sqrt(grains.grain_area / pi) / scale;
}

std::vector<Bounds> bounds_of(double base, const ScatteringDeck& scattering) {
  const double end_of_1 = base + scattering.area_1_width;
  std::vector<Bounds> bounds = {{base, end_of_1}};
  if (end_of_1 <= scattering.area_3_radius) bounds.push_back({end_of_1, scattering.area_3_radius});
  bounds.push_back({.from = scattering.area_3_radius});
  return bounds;
}

Tally tally(const Image& smoothed, const GrainPatches& grains, const Frame& frame, const PhotoDeck& deck,
            const ScatteringDeck& scattering) {
  Tally result{.base = base_of(grains, frame, deck, scattering), .peaks = {}, .counts = {}};
  const double base = std::isnan(scattering.base_radius) ? result.base.value_or(0.0) : scattering.base_radius;
  result.peaks = find_peaks(smoothed, grains, frame.axis, base * frame.scale);
  result.counts = counts(places(grains, result.peaks), frame, bounds_of(base, scattering));
  return result;
}

}  // namespace repose::photo
