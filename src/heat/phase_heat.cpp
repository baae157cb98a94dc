#include "heat/phase_heat.h"

#include <cmath>

namespace repose {
namespace {

bool holds(const PhaseHeatDeck& box, const Vec3& place) {
  return place.x >= box.min.x && place.x <= box.max.x && place.y >= box.min.y && place.y <= box.max.y &&
         place.z >= box.min.z && place.z <= box.max.z;
}

}  // namespace

/// Of the last box that holds the place and says something.
double PhaseHeat::last(const Vec3& place, double PhaseHeatDeck::*value, double otherwise) const {
  double found = otherwise;
  for (const PhaseHeatDeck& box : boxes_) {
    if (!std::isnan(box.*value) && holds(box, place)) found = box.*value;
  }
  return found;
}

}  // namespace repose
