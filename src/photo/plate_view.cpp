#include "photo/plate_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"

namespace repose::photo {
namespace {

using Kind = GrainPatches::Kind;

constexpr double least_diameter = 4.0;  // px
constexpr double most_dim = 0.5;
constexpr int centrings = 5;

/// Grains, or parts of them, at a distance from the axis.
struct Portion {
  double distance = 0.0;  ///< m
  double grains = 0.0;
};

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw DeckError(fmt::format("{}: {}", name, what));
}

double pixels_per_metre(const ScaleDeck& scale, const std::string& name) {
  if (!std::isnan(scale.pixels_per_mm)) return 1e3 * scale.pixels_per_mm;
  if (!is_given(scale.bar_from)) {
    refuse(name, "scale.plate_width is for piles from the side; give bar_from and bar_to, such as two corners of the plate, "
                 "with bar_length, or pixels_per_mm");
  }
  return std::hypot(scale.bar_to[0] - scale.bar_from[0], scale.bar_to[1] - scale.bar_from[1]) / scale.bar_length;
}

/// The middle of the pile's patch: of its pixels within a circle of nearly its own area, so that arms do not count.
Pixel middle_of_pile(const GrainPatches& grains) {
  const Patch& pile = grains.of(grains.pile);
  Pixel middle{pile.x, pile.y};
  const double radius = 0.9 * std::sqrt(pile.area / pi);
  for (int i = 0; i < centrings; ++i) {
    double x = 0.0, y = 0.0, count = 0.0;
    for (std::size_t row = pile.top; row <= pile.bottom; ++row) {
      for (std::size_t column = pile.left; column <= pile.right; ++column) {
        const auto u = static_cast<double>(column);
        const auto v = static_cast<double>(row);
        if (grains.patches.at(column, row) != grains.pile || std::hypot(u - middle.x, v - middle.y) > radius) continue;
        x += u;
        y += v;
        count += 1.0;
      }
    }
    if (count > 0.0) middle = {x / count, y / count};
  }
  return middle;
}

/// Where the plate is in the picture.
struct Frame {
  Pixel axis;
  double scale = 1.0;                             ///< px/m
  double left = 0.0, right = 0.0, up = 0.0, down = 0.0;  ///< the plate's edges from the axis, m

  double distance(double x, double y) const { return std::hypot(x - axis.x, y - axis.y) / scale; }
  bool holds(double x, double y) const {
    const double u = (x - axis.x) / scale;
    const double v = (axis.y - y) / scale;
    return u >= left && u <= right && v >= down && v <= up;
  }
};

/// Single grains at their centres, clumps pixel by pixel.
std::vector<Portion> portions(const GrainPatches& grains, const Frame& frame) {
  std::vector<Portion> result;
  const Patches& patches = grains.patches;
  for (std::size_t i = 0; i < grains.kind.size(); ++i) {
    const Patch& p = patches.all[i];
    if (grains.kind[i] == Kind::single && frame.holds(p.x, p.y)) result.push_back({frame.distance(p.x, p.y), 1.0});
    if (grains.kind[i] != Kind::clump && grains.kind[i] != Kind::pile) continue;
    for (std::size_t y = p.top; y <= p.bottom; ++y) {
      for (std::size_t x = p.left; x <= p.right; ++x) {
        if (patches.at(x, y) != static_cast<std::int32_t>(i)) continue;
        const auto u = static_cast<double>(x);
        const auto v = static_cast<double>(y);
        if (frame.holds(u, v)) result.push_back({frame.distance(u, v), 1.0 / grains.grain_area});
      }
    }
  }
  return result;
}

double diameter_of(const GrainPatches& grains, double scale) { return 2.0 * std::sqrt(grains.grain_area / pi) / scale; }

std::optional<double> base_of(const std::vector<Portion>& portions, const GrainPatches& grains, double scale,
                              const PhotoDeck& deck, const ScatteringDeck& scattering) {
  if (grains.pile < 0) return {};
  const double width =
      std::isnan(scattering.ring_width) ? 2.0 * diameter_of(grains, scale) : scattering.ring_width;
  std::vector<double> covered;
  for (const Portion& p : portions) {
    const auto ring = static_cast<std::size_t>(p.distance / width);
    if (covered.size() < ring + 2) covered.resize(ring + 2);
    covered[ring] += p.grains * grains.grain_area / (scale * scale);
  }
  for (std::size_t k = 0; k < covered.size(); ++k) covered[k] /= pi * width * width * (2.0 * static_cast<double>(k) + 1.0);
  return end_of_dense_part(covered, width, scattering.base_share * deck.plate.layer_coverage);
}

/// Areas 1, 2 and 3 as in scattering(): from, to.
struct Bounds {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

std::vector<Bounds> bounds_of(double base, const ScatteringDeck& scattering) {
  const double end_of_1 = base + scattering.area_1_width;
  std::vector<Bounds> bounds = {{base, end_of_1}};
  if (end_of_1 <= scattering.area_3_radius) bounds.push_back({end_of_1, scattering.area_3_radius});
  bounds.push_back({.from = scattering.area_3_radius});
  return bounds;
}

std::vector<double> counts(const std::vector<Portion>& portions, const std::vector<Bounds>& bounds) {
  std::vector<double> result(bounds.size(), 0.0);
  for (const Portion& p : portions) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (p.distance >= bounds[i].from && p.distance < bounds[i].to) result[i] += p.grains;
    }
  }
  return result;
}

/// Base and counts at one threshold and scale.
struct Tally {
  std::optional<double> base;
  std::vector<double> counts;
};

Tally tally(const GrainPatches& grains, const Frame& frame, const PhotoDeck& deck, const ScatteringDeck& scattering) {
  const std::vector<Portion> all = portions(grains, frame);
  Tally result{.base = base_of(all, grains, frame.scale, deck, scattering), .counts = {}};
  const double base = std::isnan(scattering.base_radius) ? result.base.value_or(0.0) : scattering.base_radius;
  result.counts = counts(all, bounds_of(base, scattering));
  return result;
}

void check_grains(const GrainPatches& grains, const Subject& subject, const PhotoDeck& deck, const std::string& name) {
  const bool has_singles = std::find(grains.kind.begin(), grains.kind.end(), Kind::single) != grains.kind.end();
  if (!has_singles && std::isnan(deck.plate.grain_diameter)) {
    refuse(name, "no grain stands alone, so that it is open how large one is; give plate.grain_diameter, or check threshold");
  }
  const double diameter = 2.0 * std::sqrt(grains.grain_area / pi);
  if (diameter < least_diameter) {
    refuse(name, fmt::format("a grain is {:.1f} pixels wide, at least {:.0f} are needed; take the photograph from nearer or "
                             "with more pixels",
                             diameter, least_diameter));
  }
  if (const double share = dim_share(grains, subject); share > most_dim) {
    refuse(name, fmt::format("the grains are out of focus: {:.0f} % of the single ones are dimmer in their middle than three "
                             "quarters of the contrast; focus on the plate",
                             100.0 * share));
  }
  if (grains.second >= 0) {
    refuse(name, fmt::format("two piles are found, the smaller with {:.0f} % of the area of the greater; crop_from and "
                             "crop_to choose one",
                             100.0 * grains.of(grains.second).area / grains.of(grains.pile).area));
  }
  if (grains.pile < 0) return;
  const Patch& pile = grains.of(grains.pile);
  if (pile.left == 0 || pile.top == 0 || pile.right + 1 == subject.excess.width || pile.bottom + 1 == subject.excess.height) {
    refuse(name, "the pile is cut off at the edge of what is looked at; take the photograph from farther away, or widen "
                 "crop_from and crop_to");
  }
}

/// Of the plate beyond the outermost circle. DeckError when the picture ends within the circle.
double seen_share(const Image& image, const Frame& frame, double outermost, const std::string& name) {
  const double w = static_cast<double>(image.width) - 0.5;
  const double h = static_cast<double>(image.height) - 0.5;
  const double nearest = std::min({frame.axis.x + 0.5, w - frame.axis.x, frame.axis.y + 0.5, h - frame.axis.y});
  if (nearest < outermost * frame.scale) {
    refuse(name, fmt::format("what is looked at ends {:.4g} mm from the axis, within area_3_radius = {:.4g} mm; take the "
                             "photograph from farther away, or widen crop_from and crop_to",
                             1e3 * nearest / frame.scale, 1e3 * outermost));
  }
  constexpr int n = 400;
  double seen = 0.0, all = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = frame.left + (frame.right - frame.left) * (i + 0.5) / n;
      const double v = frame.down + (frame.up - frame.down) * (j + 0.5) / n;
      if (std::hypot(u, v) < outermost) continue;
      const double x = frame.axis.x + frame.scale * u;
      const double y = frame.axis.y - frame.scale * v;
      all += 1.0;
      seen += x >= -0.5 && x <= w && y >= -0.5 && y <= h ? 1.0 : 0.0;
    }
  }
  return all > 0.0 ? seen / all : 1.0;
}

void count_kinds(PlateView& view, const Frame& frame) {
  for (std::size_t i = 0; i < view.grains.kind.size(); ++i) {
    const Patch& p = view.grains.patches.all[i];
    if (!frame.holds(p.x, p.y)) continue;
    const double grains = p.area / view.grains.grain_area;
    switch (view.grains.kind[i]) {
      case Kind::single: view.single += 1.0; break;
      case Kind::speck: view.specks += 1.0; break;
      case Kind::clump:
        view.merged += grains;
        if (std::abs(grains - std::round(grains)) > 0.25) view.doubtful += grains;
        break;
      case Kind::pile: break;
    }
  }
}

}  // namespace

PlateView measure_plate(const Image& image, const PhotoDeck& deck, const ScatteringDeck& scattering,
                        const std::string& name) {
  PlateView view;
  view.pixels_per_metre = pixels_per_metre(deck.scale, name);
  const Subject subject = find_subject(image, deck, Ground::around, name);
  view.contrast = subject.contrast;
  view.noise = subject.noise;
  view.is_light = subject.is_light;
  const double grain_area = pi / 4.0 * std::pow(view.pixels_per_metre * deck.plate.grain_diameter, 2);
  const auto grains_at = [&](double share) {
    return find_grains(subject, std::max(4.0 * subject.noise, share * subject.contrast), grain_area);
  };
  view.grains = grains_at(deck.threshold);
  check_grains(view.grains, subject, deck, name);
  if (view.grains.pile < 0 && !is_given(deck.plate.axis)) {
    refuse(name, "no pile is found, so that it is open where the axis is; give plate.axis and, in the base deck, "
                 "measurement.scattering.base_radius");
  }
  view.axis = is_given(deck.plate.axis) ? Pixel{deck.plate.axis[0], deck.plate.axis[1]} : middle_of_pile(view.grains);
  const Vec3 low = scattering.plate_min - scattering.axis;
  const Vec3 high = scattering.plate_max - scattering.axis;
  const Frame frame{.axis = view.axis,
                    .scale = view.pixels_per_metre,
                    .left = low.x,
                    .right = high.x,
                    .up = high.y,
                    .down = low.y};
  view.seen_share = seen_share(image, frame, scattering.area_3_radius, name);
  view.grain_diameter = diameter_of(view.grains, frame.scale);

  const Tally best = tally(view.grains, frame, deck, scattering);
  view.measured_base_radius = best.base;
  if (!best.base && std::isnan(scattering.base_radius)) {
    refuse(name, "no base of a pile is found; give measurement.scattering.base_radius in the base deck");
  }
  view.base_radius = std::isnan(scattering.base_radius) ? *best.base : scattering.base_radius;
  if (view.base_radius >= scattering.area_3_radius) {
    refuse(name, fmt::format("the pile's base has a radius of {:.4g} mm, measurement.scattering.area_3_radius is {:.4g} mm; "
                             "choose a greater one",
                             1e3 * view.base_radius, 1e3 * scattering.area_3_radius));
  }
  count_kinds(view, frame);
  if (view.doubtful > deck.plate.most_doubtful * std::max(1.0, view.single + view.merged)) {
    refuse(name, fmt::format("{:.0f} of the {:.0f} grains beside the pile stand in clumps whose area is no whole number of "
                             "grains, above plate.most_doubtful = {:.2g}; check threshold and plate.grain_diameter",
                             view.doubtful, view.single + view.merged, deck.plate.most_doubtful));
  }
  const Tally lower = tally(grains_at(std::max(0.05, deck.threshold - deck.threshold_deviation)), frame, deck, scattering);
  const Tally upper = tally(grains_at(std::min(0.95, deck.threshold + deck.threshold_deviation)), frame, deck, scattering);
  Frame wider = frame;
  wider.scale *= 1.0 + deck.scale.deviation;
  const Tally scaled = tally(view.grains, wider, deck, scattering);
  const std::vector<Bounds> bounds = bounds_of(view.base_radius, scattering);
  view.has_area_2 = bounds.size() == 3;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    CountedArea area{.from = bounds[i].from, .to = {}};
    if (std::isfinite(bounds[i].to)) area.to = bounds[i].to;
    area.count = best.counts[i];
    area.chance = std::sqrt(std::max(1.0, area.count));
    // The areas are two or three at all thresholds and scales but for a base just at the limit.
    const auto at = [&](const Tally& t) { return t.counts.size() == bounds.size() ? t.counts[i] : area.count; };
    area.threshold = 0.5 * std::abs(at(upper) - at(lower));
    area.scale = std::abs(at(scaled) - area.count);
    view.areas.push_back(area);
  }
  return view;
}

}  // namespace repose::photo
