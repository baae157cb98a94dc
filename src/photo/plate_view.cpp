#include "photo/plate_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "photo/plate_tally.h"

namespace repose::photo {
namespace {

using Kind = GrainPatches::Kind;

constexpr double default_threshold = 0.5;
constexpr double threshold_in_shade = 0.15;  // so that a pile's side in the shade counts; shadows would, of dark grains
constexpr double least_diameter = 4.0;       // px
constexpr double most_dim = 0.5;
constexpr double few_grains = 3.0;
constexpr int centrings = 5;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw DeckError(fmt::format("{}: {}", name, what));
}

double scale_of(const ScaleDeck& scale, const std::string& name) {
  if (const auto given = pixels_per_metre(scale)) return *given;
  refuse(name,
         "scale.plate_width is for piles from the side; give bar_from and bar_to, such as two corners of the plate, "
         "with bar_length, or pixels_per_mm");
}

/// The better of the two to find the pile's middle: at the lower threshold, if the pile is found there.
const GrainPatches& in_shade(const GrainPatches& grains, const GrainPatches& lower) {
  return lower.pile < 0 ? grains : lower;
}

/// The middle of the pile's patch, which has to be there: of its pixels within a circle that is a little larger than
/// it, so that arms hardly count.
Pixel middle_of_pile(const GrainPatches& grains) {
  const Patch& pile = grains.of(grains.pile);
  Pixel middle{pile.x, pile.y};
  const double radius = 1.1 * std::sqrt(pile.area / pi);
  for (int i = 0; i < centrings; ++i) {
    double x = 0.0, y = 0.0, count = 0.0;
    grains.patches.for_each_pixel(grains.pile, [&](std::size_t column, std::size_t row) {
      const auto u = static_cast<double>(column);
      const auto v = static_cast<double>(row);
      if (std::hypot(u - middle.x, v - middle.y) > radius) return;
      x += u;
      y += v;
      count += 1.0;
    });
    if (count > 0.0) middle = {x / count, y / count};
  }
  return middle;
}

void check_grains(const GrainPatches& grains, const Subject& subject, const PhotoDeck& deck, const std::string& name) {
  const bool has_singles = std::find(grains.kind.begin(), grains.kind.end(), Kind::single) != grains.kind.end();
  if (!has_singles && std::isnan(deck.plate.grain_diameter)) {
    refuse(name,
           "no grain stands alone, so that it is open how large one is; give plate.grain_diameter, or check threshold");
  }
  const double diameter = 2.0 * std::sqrt(grains.grain_area / pi);
  if (diameter < least_diameter) {
    refuse(name,
           fmt::format("a grain is {:.1f} pixels wide, at least {:.0f} are needed; take the photograph from nearer or "
                       "with more pixels",
                       diameter, least_diameter));
  }
  if (const double share = dim_share(grains, subject); share > most_dim) {
    refuse(name,
           fmt::format("the grains are out of focus: {:.0f} % of the single ones are dimmer in their middle than three "
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
  if (pile.left == 0 || pile.top == 0 || pile.right + 1 == subject.excess.width ||
      pile.bottom + 1 == subject.excess.height) {
    refuse(name,
           "the pile is cut off at the edge of what is looked at; take the photograph from farther away, or widen "
           "crop_from and crop_to");
  }
}

/// Of the plate beyond the outermost circle. DeckError when the picture ends within the circle.
double seen_share(const Image& image, const Frame& frame, double outermost, const std::string& name) {
  const double w = static_cast<double>(image.width) - 0.5;
  const double h = static_cast<double>(image.height) - 0.5;
  const double nearest = std::min({frame.axis.x + 0.5, w - frame.axis.x, frame.axis.y + 0.5, h - frame.axis.y});
  if (nearest < outermost * frame.scale) {
    refuse(name,
           fmt::format("what is looked at ends {:.4g} mm from the axis, within area_3_radius = {:.4g} mm; take the "
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

/// Whether peaks are looked for everywhere in the patch.
bool is_beyond_base(const Patch& p, const PlateView& view, const Frame& frame) {
  const double extent = std::hypot(static_cast<double>(p.right - p.left), static_cast<double>(p.bottom - p.top));
  return frame.distance(p.x, p.y) - extent / frame.scale > view.base_radius;
}

void count_kinds(PlateView& view, const Frame& frame) {
  std::vector<double> peaks(view.grains.kind.size(), 0.0);
  for (const GrainPeak& peak : view.peaks) peaks[static_cast<std::size_t>(peak.patch)] += 1.0;
  for (std::size_t i = 0; i < view.grains.kind.size(); ++i) {
    const Patch& p = view.grains.patches.all[i];
    if (!frame.holds(p.x, p.y)) continue;
    switch (view.grains.kind[i]) {
      case Kind::single:
        view.single += 1.0;
        break;
      case Kind::speck:
        view.specks += 1.0;
        view.speck_grains += p.area / view.grains.grain_area;
        break;
      case Kind::clump:
        view.merged += peaks[i];
        if (is_beyond_base(p, view, frame)) {
          view.doubtful += std::abs(peaks[i] - std::round(p.area / view.grains.grain_area));
        }
        break;
      case Kind::pile:
        view.merged += peaks[i];
        break;
    }
  }
}

/// Counts that hang on the threshold are none.
void check_sensitivity(const PlateView& view, const PhotoDeck& deck, const std::string& name) {
  double all = 0.0, change = 0.0;
  for (const CountedArea& area : view.areas) {
    all += area.count;
    change += area.threshold;
  }
  if (change <= std::max(few_grains, deck.plate.most_doubtful * all)) return;
  refuse(name,
         fmt::format("of {:.0f} grains {:.0f} come or go with the threshold's deviation: choose another threshold or "
                     "channel, or more even light",
                     all, change));
}

}  // namespace

PlateView measure_plate(const Image& image, const PhotoDeck& deck, const ScatteringDeck& scattering,
                        const std::string& name) {
  PlateView view;
  view.pixels_per_metre = scale_of(deck.scale, name);
  const Subject subject = find_subject(image, deck, Ground::around, name);
  view.contrast = subject.contrast;
  view.noise = subject.noise;
  view.is_light = subject.is_light;
  const double diameter = view.pixels_per_metre * deck.plate.grain_diameter;
  const double grain_area = std::isnan(diameter) ? 0.0 : pi / 4.0 * diameter * diameter;
  const auto grains_at = [&](double share) {
    return find_grains(subject, std::max(5.0 * subject.noise, share * subject.contrast), deck.plate.least_roundness,
                       grain_area);
  };
  const Thresholds thresholds = thresholds_of(deck, default_threshold);
  view.grains = grains_at(thresholds.best);
  check_grains(view.grains, subject, deck, name);
  if (view.grains.pile < 0 && !is_given(deck.plate.axis)) {
    refuse(name,
           "no pile is found, so that it is open where the axis is; give plate.axis and, in the base deck, "
           "measurement.scattering.base_radius");
  }
  view.axis =
      is_given(deck.plate.axis)
          ? Pixel{deck.plate.axis[0], deck.plate.axis[1]}
          : middle_of_pile(subject.is_light ? in_shade(view.grains, grains_at(threshold_in_shade)) : view.grains);
  const Vec3 low = scattering.plate_min - scattering.axis;
  const Vec3 high = scattering.plate_max - scattering.axis;
  const Frame frame{
      .axis = view.axis, .scale = view.pixels_per_metre, .left = low.x, .right = high.x, .up = high.y, .down = low.y};
  view.seen_share = seen_share(image, frame, scattering.area_3_radius, name);
  view.grain_diameter = seen_diameter(view.grains, frame.scale);

  const Image smoothed = smoothed_for(subject, view.grains);
  Tally best = tally(smoothed, view.grains, frame, deck, scattering);
  view.measured_base_radius = best.base;
  view.peaks = std::move(best.peaks);
  if (!best.base && std::isnan(scattering.base_radius)) {
    refuse(name, "no base of a pile is found; give measurement.scattering.base_radius in the base deck");
  }
  view.base_radius = std::isnan(scattering.base_radius) ? *best.base : scattering.base_radius;
  if (view.base_radius >= scattering.area_3_radius) {
    refuse(name,
           fmt::format("the pile's base has a radius of {:.4g} mm, measurement.scattering.area_3_radius is {:.4g} mm; "
                       "choose a greater one",
                       1e3 * view.base_radius, 1e3 * scattering.area_3_radius));
  }
  count_kinds(view, frame);
  if (view.speck_grains > deck.plate.most_doubtful * std::max(1.0, view.single + view.merged)) {
    refuse(name,
           fmt::format(
               "parts too small for a grain have the area of {:.1f} grains, {:.0f} are found beside the pile: what is "
               "taken for a grain may be several, or grains fall into parts; check threshold, channel and "
               "plate.least_roundness",
               view.speck_grains, view.single + view.merged));
  }
  if (view.doubtful > deck.plate.most_doubtful * std::max(1.0, view.single + view.merged)) {
    refuse(name, fmt::format(
                     "clumps have the area of {:.0f} grains more or fewer than are seen in them, of {:.0f} beside the "
                     "pile, above plate.most_doubtful = {:.2g}; another threshold or more pixels may help",
                     view.doubtful, view.single + view.merged, deck.plate.most_doubtful));
  }
  const auto tally_at = [&](double share) {
    const GrainPatches grains = grains_at(share);
    return tally(smoothed_for(subject, grains), grains, frame, deck, scattering);
  };
  const Tally lower = tally_at(thresholds.lower);
  const Tally upper = tally_at(thresholds.upper);
  Frame wider = frame;
  wider.scale *= 1.0 + deck.scale.deviation;
  const Tally scaled = tally(smoothed, view.grains, wider, deck, scattering);
  const std::vector<Bounds> bounds = bounds_of(view.base_radius, scattering);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    CountedArea area{.number = i + 1 == bounds.size() ? 3 : static_cast<int>(i) + 1, .from = bounds[i].from, .to = {}};
    if (std::isfinite(bounds[i].to)) area.to = bounds[i].to;
    area.count = best.counts[i];
    area.chance = std::sqrt(std::max(1.0, area.count));
    // The areas are two or three at all thresholds and scales but for a base just at the limit.
    const auto at = [&](const Tally& t) { return t.counts.size() == bounds.size() ? t.counts[i] : area.count; };
    area.threshold = 0.5 * std::abs(at(upper) - at(lower));
    area.scale = std::abs(at(scaled) - area.count);
    view.areas.push_back(area);
  }
  check_sensitivity(view, deck, name);
  return view;
}

}  // namespace repose::photo
