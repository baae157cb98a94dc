#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

/// The box around the region of a block, but for the tilt of a disc.
DomainDeck bounds(const ParticlesDeck& p) {
  if (p.region == RegionShape::box) return {p.min, p.max};
  if (p.region == RegionShape::disc) return {p.centre, p.centre};
  const double r = std::max(p.radius, p.radius_top);
  return {{p.centre.x - r, p.centre.y - r, p.centre.z}, {p.centre.x + r, p.centre.y + r, p.centre.z + p.height}};
}

/// The outline of a face is known when its file has been read.
void check_face(const std::string& section, const ParticlesDeck& p, const Deck& deck, DeckErrors& errors) {
  const WallDeck* const found = find_wall(section + ".face", p.face, deck, errors);
  if (found == nullptr) return;
  const WallDeck& wall = *found;
  if (wall.type != WallType::mesh && wall.type != WallType::rectangle) {
    errors.add(section + ".face", fmt::format("wall \"{}\" is neither a mesh nor a rectangle", p.face));
  }
  if (wall.present || !wall.motions.empty() || wall.servo.enabled) {
    errors.add(
        section + ".face",
        fmt::format("wall \"{}\" would stand in the way; give it present = false, no motion and no servo", p.face));
  }
  for (const PhaseDeck& phase : deck.phases) {
    if (std::find(phase.add_walls.begin(), phase.add_walls.end(), p.face) == phase.add_walls.end()) continue;
    errors.add(section + ".face", fmt::format("phase \"{}\" adds wall \"{}\", through which particles enter; take it "
                                              "out of add_walls",
                                              phase.name, p.face));
  }
}

/// Exactly one of two keys.
void check_one_of(const std::string& section, const char* a, bool has_a, const char* b, bool has_b,
                  DeckErrors& errors) {
  if (has_a && has_b) {
    errors.add(fmt::format("{}.{}", section, b), fmt::format("\"{}\" and \"{}\" are both given; remove one", a, b));
  }
  if (!has_a && !has_b) {
    errors.add(section, fmt::format("[[particles]] lacks \"{}\" or \"{}\"; give one of them", a, b));
  }
}

void check_classes(const std::string& section, const SizesDeck& s, DeckErrors& errors) {
  if (s.diameters.empty()) errors.add(section + ".diameters", "\"diameters\" is empty; give at least one");
  if (s.shares.size() != s.diameters.size()) {
    errors.add(section + ".shares", fmt::format("{} \"shares\" for {} \"diameters\"; give one for each",
                                                s.shares.size(), s.diameters.size()));
  }
  if (!std::is_sorted(s.diameters.begin(), s.diameters.end(), std::less_equal<>())) {
    errors.add(section + ".diameters", "\"diameters\" must increase");
  }
  if (std::all_of(s.shares.begin(), s.shares.end(), [](double share) { return share == 0.0; })) {
    errors.add(section + ".shares", "\"shares\" are all 0");
  }
}

void check_sizes(const std::string& section, const SizesDeck& s, DeckErrors& errors) {
  if (s.type == SizesType::classes) check_classes(section, s, errors);
  if (s.min_diameter >= s.max_diameter) {
    errors.add(section + ".max_diameter",
               fmt::format("\"max_diameter\" = {} must be greater than \"min_diameter\" = {}", s.max_diameter,
                           s.min_diameter));
  }
}

/// That a region lies in the domain. One that reaches a metre beyond is one whose unit was forgotten.
void check_inside(const std::string& section, const DomainDeck& region, const DomainDeck& domain, DeckErrors& errors) {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const double Vec3::*a = component(axis);
    const bool is_below = region.min.*a < domain.min.*a;
    if (!is_below && region.max.*a <= domain.max.*a) continue;
    const double reach = is_below ? region.min.*a : region.max.*a;
    const double bound = is_below ? domain.min.*a : domain.max.*a;
    const bool lacks_unit = std::fabs(reach - bound) >= 1.0;
    errors.add(section + ".region",
               fmt::format("the region reaches to {} = {:.6g} m, beyond [domain] {} = {:.6g} m; enlarge the domain{}",
                           enumerators(Axis{})[static_cast<std::size_t>(axis)], reach, is_below ? "min" : "max", bound,
                           lacks_unit ? fmt::format(", or give the unit (\"{:.4g} mm\")", reach) : ""));
    return;
  }
}

void check_region(const std::string& section, const ParticlesDeck& p, const DomainDeck& domain, DeckErrors& errors) {
  if (p.region == RegionShape::disc && p.type != ParticlesType::pour) {
    errors.add(section + ".region", "a disc has no volume to fill; only type = \"pour\" can use it");
  }
  if (p.region == RegionShape::disc && !(squared_norm(p.normal) > 0.0)) {
    errors.add(section + ".normal", "\"normal\" has no length");
  }
  if (p.region == RegionShape::box) check_box(section, p.min, p.max, errors);
  const DomainDeck box = bounds(p);
  const Vec3 size = box.max - box.min;
  if (p.region != RegionShape::disc && p.diameter > std::min({size.x, size.y, size.z})) {
    errors.add(section + ".diameter", fmt::format("\"diameter\" = {} is larger than the region", p.diameter));
  }
  if (p.region == RegionShape::disc && p.diameter > 2.0 * p.radius) {
    errors.add(section + ".diameter", fmt::format("\"diameter\" = {} is larger than the disc", p.diameter));
  }
  check_inside(section, box, domain, errors);
}

/// A block whose amount and sizes the deck gives: fill or pour.
void check_measured(const std::string& section, const ParticlesDeck& p, DeckErrors& errors) {
  check_one_of(section, "mass", p.mass > 0.0, "count", p.count > 0, errors);
  check_one_of(section, "diameter", p.diameter > 0.0, "sizes", p.sizes.enabled, errors);
  if (p.sizes.enabled) check_sizes(section + ".sizes", p.sizes, errors);
  if (p.type == ParticlesType::pour) {
    check_one_of(section, "rate", p.rate > 0.0, "particle_rate", p.particle_rate > 0.0, errors);
  } else if (p.spacing < p.diameter) {
    errors.add(section + ".spacing",
               fmt::format("\"spacing\" = {} is less than the diameter {}", p.spacing, p.diameter));
  } else if (p.sizes.enabled && !std::isnan(p.spacing)) {
    errors.add(section + ".spacing",
               "\"spacing\" has no meaning with [particles.sizes], which fills at random; remove it");
  }
  if (p.sizes.enabled && p.jitter != ParticlesDeck{}.jitter) {
    errors.add(section + ".jitter",
               "\"jitter\" has no meaning with [particles.sizes], which fills at random; remove it");
  }
}

void check_lattice(const std::string& section, const ParticlesDeck& p, DeckErrors& errors) {
  const double nearest = p.spacing * (p.lattice == LatticeType::simple_cubic   ? 1.0
                                      : p.lattice == LatticeType::body_centred ? std::sqrt(0.75)
                                                                               : std::sqrt(0.5));
  if (nearest < p.diameter * (1.0 - 1e-12)) {
    errors.add(section + ".spacing",
               fmt::format("\"spacing\" = {} puts the nearest sites at {:.6g}, less than the diameter {}", p.spacing,
                           nearest, p.diameter));
  }
  if (!p.counts.empty() && p.counts.size() != 3) {
    errors.add(section + ".counts", fmt::format("\"counts\" must be three numbers, not {}", p.counts.size()));
  }
}

}  // namespace

void check_particles(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.particles.size(); ++i) {
    const ParticlesDeck& p = deck.particles[i];
    const std::string section = fmt::format("particles.{}", i);
    if (comes_from_file(p.type)) continue;
    if (p.type == ParticlesType::lattice) {
      check_lattice(section, p, errors);
    } else {
      check_measured(section, p, errors);
    }
    if (!p.counts.empty()) continue;
    if (p.region != RegionShape::face) {
      check_region(section, p, deck.domain, errors);
    } else if (p.type == ParticlesType::pour) {
      check_face(section, p, deck, errors);
    } else {
      errors.add(section + ".region", "a face has no volume to fill; only type = \"pour\" can use it");
    }
  }
}

}  // namespace repose
