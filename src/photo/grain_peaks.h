#pragma once

#include <vector>

#include "photo/grain_patches.h"

namespace repose::photo {

/// A grain of a clump or at the foot of the pile.
struct GrainPeak {
  Pixel at;
  std::int32_t patch = -1;
};

/// The excess, smoothed over two fifths of a grain's diameter.
Image smoothed_for(const Subject& subject, const GrainPatches& grains);

/// The grains within clumps and the pile, but for those nearer to `axis` than `beyond` (px): where `smoothed`
/// (smoothed_for) is greatest within a third of a diameter around. As in particle tracking
/// (Crocker and Grier 1996, doi:10.1006/jcis.1996.0217), whose background is taken away already.
std::vector<GrainPeak> find_peaks(const Image& smoothed, const GrainPatches& grains, Pixel axis, double beyond);

}  // namespace repose::photo
