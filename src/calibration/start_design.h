#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "calibration/parameter_range.h"

namespace repose {

/// The points that an adaptive search starts from, in the parameters' units: of many Latin hypercubes the one whose
/// two nearest points are the farthest apart (Johnson, Moore, Ylvisaker 1990, doi:10.1016/0378-3758(90)90122-B). A
/// hypercube shows each parameter at as many values as there are points, where a small grid shows two or three; its
/// outermost values are the ends of the range. In more than three dimensions, where no number of tries fills the space,
/// its points are then spread by exchanges (Morris, Mitchell 1995, doi:10.1016/0378-3758(94)00035-T). A function of its
/// arguments alone. DeckError for no point.
std::vector<std::vector<double>> start_design(const std::vector<ParameterRange>& ranges, std::size_t points,
                                              std::uint64_t seed);

/// So many points in the parameters' units, each of many random ones the farthest from all before and from `known`.
std::vector<std::vector<double>> points_between(const std::vector<ParameterRange>& ranges,
                                                std::span<const std::vector<double>> known, std::size_t points,
                                                std::uint64_t seed);

}  // namespace repose
