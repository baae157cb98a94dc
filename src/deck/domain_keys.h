#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// The domain and its exits.
namespace repose {

enum class Axis { x, y, z };
constexpr auto enumerators(Axis) { return std::array<std::string_view, 3>{"x", "y", "z"}; }

/// The component of a vector along an axis.
constexpr double Vec3::*component(Axis axis) {
  return axis == Axis::x ? &Vec3::x : axis == Axis::y ? &Vec3::y : &Vec3::z;
}

/// The unit vector along an axis.
inline Vec3 unit_along(Axis axis) {
  Vec3 unit;
  unit.*component(axis) = 1.0;
  return unit;
}

struct DomainDeck {
  Vec3 min;
  Vec3 max;
  std::vector<Axis> periodic = {};  ///< directions in which the domain repeats itself
};

template <class V>
void describe(V& v, DomainDeck& d) {
  v("min", d.min, Unit::metre, any_value, required, "lowest corner");
  v("max", d.max, Unit::metre, any_value, required, "highest corner, beyond min in x, y and z");
  v("periodic", d.periodic, Unit::none, any_value, optional,
    "directions in which the domain repeats itself: what leaves it there comes in on the other side");
}

inline bool is_periodic(const DomainDeck& domain, Axis axis) {
  return std::find(domain.periodic.begin(), domain.periodic.end(), axis) != domain.periodic.end();
}

enum class DomainFace { x_min, x_max, y_min, y_max, z_min, z_max };
constexpr auto enumerators(DomainFace) {
  return std::array<std::string_view, 6>{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
}

struct ExitDeck {
  std::string name;
  DomainFace face = DomainFace::z_min;
  Vec3 min{unset, unset, unset};  ///< of the part of the face; default: the domain's
  Vec3 max{unset, unset, unset};
};

template <class V>
void describe(V& v, ExitDeck& e) {
  v("name", e.name, Unit::none, any_value, required, "name, used once");
  v("face", e.face, Unit::none, any_value, required, "face of the domain");
  v("min", e.min, Unit::metre, any_value, optional_else("the domain's min"),
    "lowest corner of the part; across the face it does not matter");
  v("max", e.max, Unit::metre, any_value, optional_else("the domain's max"), "highest corner of the part");
}

}  // namespace repose
