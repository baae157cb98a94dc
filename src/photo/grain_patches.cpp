#include "photo/grain_patches.h"

#include <algorithm>

namespace repose::photo {
namespace {

constexpr double area_range = 4.0;  // of a single grain, about the median, either way
constexpr double speck_share = 0.2;
constexpr double least_pile = 20.0;  // grains
constexpr double second_share = 0.5;
constexpr double least_area = 12.5;  // px^2, of a grain of 4 px: less is noise

bool may_be_single(const Patch& patch, double least_roundness) {
  return patch.area >= least_area && patch.roundness >= least_roundness;
}

double median_area(const std::vector<Patch>& all, double least_roundness) {
  std::vector<float> areas;
  for (const Patch& p : all) {
    if (may_be_single(p, least_roundness)) areas.push_back(static_cast<float>(p.area));
  }
  return areas.empty() ? 0.0 : static_cast<double>(median(areas));
}

}  // namespace

GrainPatches find_grains(const Subject& subject, double threshold, double least_roundness, double otherwise) {
  GrainPatches result;
  result.patches = find_patches(subject.excess.width, subject.excess.height,
                                [&](std::size_t x, std::size_t y) { return subject.excess.at(x, y) > threshold; });
  const std::vector<Patch>& all = result.patches.all;
  const double middle = median_area(all, least_roundness);
  result.kind.assign(all.size(), GrainPatches::Kind::clump);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!may_be_single(all[i], least_roundness) || all[i].area < middle / area_range ||
        all[i].area > middle * area_range)
      continue;
    result.kind[i] = GrainPatches::Kind::single;
    sum += all[i].area;
    count += 1.0;
  }
  result.grain_area = count > 0.0 ? sum / count : otherwise;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (result.kind[i] == GrainPatches::Kind::clump && all[i].area < speck_share * result.grain_area) {
      result.kind[i] = GrainPatches::Kind::speck;
    }
  }
  const Largest found = largest(all);
  if (result.grain_area > 0.0 && found.first >= 0 && result.of(found.first).area >= least_pile * result.grain_area) {
    result.pile = found.first;
    result.kind[static_cast<std::size_t>(found.first)] = GrainPatches::Kind::pile;
    if (found.second >= 0 && result.of(found.second).area >= second_share * result.of(found.first).area) {
      result.second = found.second;
    }
  }
  return result;
}

double dim_share(const GrainPatches& grains, const Subject& subject) {
  double dim = 0.0, count = 0.0;
  for (std::size_t i = 0; i < grains.kind.size(); ++i) {
    if (grains.kind[i] != GrainPatches::Kind::single) continue;
    const Patch& p = grains.patches.all[i];
    float brightest = 0.0F;
    for (std::size_t y = p.top; y <= p.bottom; ++y) {
      for (std::size_t x = p.left; x <= p.right; ++x) brightest = std::max(brightest, subject.excess.at(x, y));
    }
    dim += static_cast<double>(brightest) < 0.75 * subject.contrast ? 1.0 : 0.0;
    count += 1.0;
  }
  return count > 0.0 ? dim / count : 0.0;
}

}  // namespace repose::photo
