#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/materials_used.h"

namespace repose {

/// Templates of a distribution that are one material.
struct Portion {
  std::string material = {};
  double density = 0.0;
  double number_share = 0.0;              ///< of all grains
  double mass_share = 0.0;                ///< of their mass
  double mean_mass = 0.0;                 ///< kg
  std::map<double, double> classes = {};  ///< share by diameter, of mass or number as the distribution says
};

/// By material, of a distribution of a script.
std::vector<Portion> portions(const ImportedScene& scene, const ScriptDistribution& distribution,
                              const MaterialsUsed& materials);

double largest_diameter(const std::vector<Portion>& portions);

/// Grains that are in a region.
struct Amount {
  double count = 0.0;
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m3
};

/// Of the grains of lists.
Amount amount_of_list(const ImportedScene& scene, const ScriptRegion& region);

/// How many grains of one of its portions a pack brings into a region (m3) that holds some already.
double lacking(const ScriptInsertion& pack, const std::vector<Portion>& portions, const Portion& portion, double volume,
               const Amount& there);
/// The same of all portions.
Amount lacking(const ScriptInsertion& pack, const std::vector<Portion>& portions, double volume, const Amount& there);

}  // namespace repose
