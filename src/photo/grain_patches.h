#pragma once

#include <string>
#include <vector>

#include "photo/patches.h"
#include "photo/photo_deck.h"
#include "photo/subject.h"

namespace repose::photo {

/// The patches of a picture from above, sorted by what they are.
struct GrainPatches {
  enum class Kind { speck, single, clump, pile };
  Patches patches;
  std::vector<Kind> kind;    ///< of each patch
  double grain_area = 0.0;   ///< mean of the single grains, px^2
  std::int32_t pile = -1;    ///< -1: there is none
  std::int32_t second = -1;  ///< a patch of half its area or more

  const Patch& of(std::int32_t i) const { return patches.all[static_cast<std::size_t>(i)]; }
};

/// The patches above `threshold`. A grain is single when its patch is round (Patch::roundness at least
/// `least_roundness`) and has between a quarter and four times the median area of such; a patch of less than a fifth of
/// their mean is a speck; the largest is the pile when it has the area of 20 grains. Where no patch is single,
/// grain_area is `otherwise` (px^2).
GrainPatches find_grains(const Subject& subject, double threshold, double least_roundness, double otherwise);

/// Share of the single grains that are less bright in their middle than three quarters of the contrast: of a sharp
/// picture few.
double dim_share(const GrainPatches& grains, const Subject& subject);

}  // namespace repose::photo
