#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/sizes/size_distribution.h"

namespace repose {

/// A class of diameters, m; one of a single diameter has from == to.
struct SizeClass {
  double from;
  double to;
};

/// Figures of a size distribution: diameters in m that 10, 50 and 90 % of the mass are below, mean diameter of the
/// particles in m, share of the mass in each class.
struct SizeFigures {
  double d10 = 0.0;
  double d50 = 0.0;
  double d90 = 0.0;
  double mean = 0.0;
  std::vector<double> mass_shares;
};

/// The sizes a block asked for and those its particles got.
struct SizeReport {
  std::string block;
  std::vector<SizeClass> classes;  ///< those of a discrete distribution, else ten of equal mass
  SizeFigures asked;
  SizeFigures realised;
};

/// Compares the radii (m) of the particles of a block, at least one, with the distribution they were drawn from.
SizeReport report_sizes(const std::string& block, const SizeDistribution& asked, std::span<const double> radii);

/// The report as lines for a person.
std::string size_report_text(const SizeReport& report);

}  // namespace repose
