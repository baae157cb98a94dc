#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "deck/wall_keys.h"

/// Blocks of particles and their sizes.
namespace repose {

enum class SizesType { classes, lognormal, weibull, uniform, csv };
enum class Weighting { mass, number };
constexpr auto enumerators(SizesType) {
  return std::array<std::string_view, 5>{"classes", "lognormal", "weibull", "uniform", "csv"};
}
constexpr auto enumerators(Weighting) { return std::array<std::string_view, 2>{"mass", "number"}; }

struct SizesDeck {
  bool enabled = false;  ///< true when the block has the section
  SizesType type = SizesType::classes;
  Weighting by = Weighting::mass;      ///< what the shares are shares of; csv: its header line says
  std::vector<double> diameters;       ///< classes
  std::vector<double> shares;          ///< classes: one per diameter, of any sum
  double median = unset;               ///< lognormal: half is smaller
  double geometric_deviation = unset;  ///< lognormal: above 1; 68 % lie between median / and x this
  double scale = unset;                ///< weibull: diameter that 63.2 % are smaller than
  double shape = unset;                ///< weibull: exponent
  double min_diameter = unset;         ///< nothing is smaller (classes: not used)
  double max_diameter = unset;         ///< nothing is larger (classes: not used)
  std::string file;                    ///< csv: path relative to the deck
};

template <class V>
void describe(V& v, SizesDeck& s) {
  v("type", s.type, Unit::none, any_value, required,
    "classes: single diameters; weibull: Rosin-Rammler; csv: a sieve or laser analysis");
  const bool is_classes = s.type == SizesType::classes;
  const bool is_lognormal = s.type == SizesType::lognormal;
  const bool is_weibull = s.type == SizesType::weibull;
  const bool is_csv = s.type == SizesType::csv;
  const bool is_bounded = !is_classes && !is_csv;
  v("by", s.by, Unit::none, any_value, optional.when(!is_csv, "type other than csv"),
    "whether it is a distribution of the mass or of the number of particles");
  v("diameters", s.diameters, Unit::metre, above(0), required.when(is_classes, "type = classes"),
    "the diameters, from small to large");
  v("shares", s.shares, Unit::none, at_least(0), required.when(is_classes, "type = classes"),
    "share of each diameter, of any sum");
  v("median", s.median, Unit::metre, above(0), required.when(is_lognormal, "type = lognormal"),
    "half is smaller, before the ends are cut");
  v("geometric_deviation", s.geometric_deviation, Unit::none, above(1), required.when(is_lognormal, "type = lognormal"),
    "68 % lie between median / this and median x this");
  v("scale", s.scale, Unit::metre, above(0), required.when(is_weibull, "type = weibull"),
    "63.2 % are smaller, before the ends are cut");
  v("shape", s.shape, Unit::none, above(0), required.when(is_weibull, "type = weibull"),
    "exponent; the greater, the narrower");
  v("min_diameter", s.min_diameter, Unit::metre, above(0),
    (is_bounded ? required : optional_else("the first of the file")).when(!is_classes, "type other than classes"),
    "what is smaller is left out");
  v("max_diameter", s.max_diameter, Unit::metre, above(0),
    (is_bounded ? required : optional_else("the last of the file")).when(!is_classes, "type other than classes"),
    "what is larger is left out");
  v("file", s.file, Unit::none, any_value, required.when(is_csv, "type = csv"),
    "path from the deck's folder; columns diameter, diameter_mm or diameter_um and "
    "cumulative_mass, cumulative_number, share_mass or share_number");
}

enum class ParticlesType { fill, lattice, csv, snapshot, pour };
enum class RegionShape { cylinder, box, disc, face };
enum class LatticeType { simple_cubic, body_centred, face_centred };
constexpr auto enumerators(ParticlesType) {
  return std::array<std::string_view, 5>{"fill", "lattice", "csv", "snapshot", "pour"};
}
constexpr auto enumerators(RegionShape) { return std::array<std::string_view, 4>{"cylinder", "box", "disc", "face"}; }
constexpr auto enumerators(LatticeType) {
  return std::array<std::string_view, 3>{"simple_cubic", "body_centred", "face_centred"};
}

/// Whether a file lists the particles of a block with their materials and sizes.
constexpr bool comes_from_file(ParticlesType type) {
  return type == ParticlesType::csv || type == ParticlesType::snapshot;
}

struct ParticlesDeck {
  ParticlesType type = ParticlesType::fill;
  std::string material;                             ///< fill, lattice, pour
  double diameter = unset;                          ///< fill, lattice, pour; or sizes
  SizesDeck sizes;                                  ///< fill, pour; or diameter
  double mass = unset;                              ///< fill, pour: total mass; or count
  std::int64_t count = 0;                           ///< fill, pour: number of particles; or mass
  RegionShape region = RegionShape::cylinder;       ///< fill, lattice, pour; disc, face: pour
  Vec3 centre;                                      ///< cylinder: of the bottom, the axis is vertical (z); disc
  double radius = unset;                            ///< cylinder: at the bottom; disc
  double radius_top = unset;                        ///< cylinder: at the top (a cone frustum); default: radius
  double height = unset;                            ///< cylinder
  Vec3 min;                                         ///< box
  Vec3 max;                                         ///< box
  Vec3 normal{0.0, 0.0, 1.0};                       ///< disc
  std::string face;                                 ///< face: name of a wall that is never present
  double spacing = unset;                           ///< fill, lattice: lattice constant; fill: default 1.1 diameters
  double jitter = 1.0;                              ///< fill: share of the free gap that a particle may be moved by
  LatticeType lattice = LatticeType::simple_cubic;  ///< lattice
  std::vector<std::int64_t> counts;                 ///< lattice: cells along x, y and z; or region
  Vec3 first;                                       ///< lattice with counts: first site
  Vec3 velocity;                                    ///< fill, lattice, pour: initial velocity
  double rate = unset;                              ///< pour: mass per time; or particle_rate
  double particle_rate = unset;                     ///< pour: particles per time; or rate
  double start_time = 0.0;                          ///< pour
  double interval = unset;                          ///< pour: between batches; default: the time to clear the region
  std::string file;                                 ///< csv, snapshot: path relative to the deck
  bool fixed = false;                               ///< held in place, of infinite mass
  bool rotation_blocked = false;                    ///< moves but never turns
  std::vector<MotionDeck> motions;                  ///< [[particles.motion]]: held on a prescribed path
  double temperature = unset;                       ///< default: that of [heat]
  bool isothermal = false;                          ///< keeps its temperature, whatever heat flows
  double heating = 0.0;                             ///< power of sources inside per mass
};

template <class V>
void describe_region(V& v, ParticlesDeck& p) {
  const bool is_made = !comes_from_file(p.type);
  const bool by_counts = p.type == ParticlesType::lattice && !p.counts.empty();
  const bool has_region = is_made && !by_counts;
  v("region", p.region, Unit::none, any_value,
    required.when(has_region, "type = fill, pour, or lattice without counts"),
    "shape of the region; a cylinder is upright (z); disc, face: pour only");
  const bool is_cylinder = has_region && p.region == RegionShape::cylinder;
  const bool is_box = has_region && p.region == RegionShape::box;
  const bool is_disc = has_region && p.region == RegionShape::disc;
  v("centre", p.centre, Unit::metre, any_value, required.when(is_cylinder || is_disc, "region = cylinder, disc"),
    "centre of the cylinder's bottom or of the disc");
  v("radius", p.radius, Unit::metre, above(0), required.when(is_cylinder || is_disc, "region = cylinder, disc"),
    "radius of the disc or at the cylinder's bottom");
  v("radius_top", p.radius_top, Unit::metre, above(0), optional_else("radius").when(is_cylinder, "region = cylinder"),
    "radius at the top (a cone frustum)");
  v("height", p.height, Unit::metre, above(0), required.when(is_cylinder, "region = cylinder"), "height");
  v("min", p.min, Unit::metre, any_value, required.when(is_box, "region = box"), "lowest corner");
  v("max", p.max, Unit::metre, any_value, required.when(is_box, "region = box"), "highest corner");
  v("normal", p.normal, Unit::none, any_value, optional.when(is_disc, "region = disc"), "normal, of any length");
  v("face", p.face, Unit::none, any_value, required.when(has_region && p.region == RegionShape::face, "region = face"),
    "name of a flat mesh or rectangle among the walls, with present = false, through which they enter");
}

template <class V>
void describe_pour(V& v, ParticlesDeck& p) {
  const bool is_pour = p.type == ParticlesType::pour;
  v("rate", p.rate, Unit::mass_rate, above(0),
    optional_else("none; this or particle_rate").when(is_pour, "type = pour"), "mass per time");
  v("particle_rate", p.particle_rate, Unit::per_second, above(0),
    optional_else("none; this or rate").when(is_pour, "type = pour"), "particles per time");
  v("start_time", p.start_time, Unit::second, from_to(0, 1e12), optional.when(is_pour, "type = pour"),
    "time of the run at which it begins");
  v("interval", p.interval, Unit::second, above_to(0, 1e12),
    optional_else("time to clear the region").when(is_pour, "type = pour"), "time between batches");
}

template <class V>
void describe(V& v, ParticlesDeck& p) {
  v("type", p.type, Unit::none, any_value, required,
    "fill: spread in a region; lattice: regular; csv: a list; snapshot: the state of another run; pour: at a rate");
  const bool is_fill = p.type == ParticlesType::fill;
  const bool is_lattice = p.type == ParticlesType::lattice;
  const bool is_measured = is_fill || p.type == ParticlesType::pour;
  const bool is_made = !comes_from_file(p.type);
  v("file", p.file, Unit::none, any_value, required.when(!is_made, "type = csv, snapshot"),
    "path from the deck's folder; csv: columns x,y,z,vx,vy,vz,wx,wy,wz,radius,material or x,y,z,radius,material");
  v("material", p.material, Unit::none, any_value, required.when(is_made, "type = fill, lattice, pour"),
    "name of the material");
  v("diameter", p.diameter, Unit::metre, above(0),
    (is_lattice ? required : optional_else("none; this or [particles.sizes]"))
        .when(is_made, "type = fill, lattice, pour"),
    "diameter of the spheres");
  v("mass", p.mass, Unit::kilogram, above(0),
    optional_else("none; this or count").when(is_measured, "type = fill, pour"), "total mass, to within one particle");
  v("count", p.count, Unit::none, at_least(1),
    optional_else("none; this or mass").when(is_measured, "type = fill, pour"), "number of particles");
  v("lattice", p.lattice, Unit::none, any_value, optional.when(is_lattice, "type = lattice"), "cubic lattice");
  v("counts", p.counts, Unit::none, at_least(1),
    optional_else("none; this or region").when(is_lattice, "type = lattice"), "[x, y, z]: number of cubic cells");
  const bool by_counts = is_lattice && !p.counts.empty();
  v("first", p.first, Unit::metre, any_value, required.when(by_counts, "counts"), "first site of the lattice");
  describe_region(v, p);
  v("spacing", p.spacing, Unit::metre, above(0),
    (is_lattice ? required : optional_else("1.1 diameters")).when(is_fill || is_lattice, "type = fill, lattice"),
    "lattice constant; fill: at least the diameter, unused with sizes");
  v("jitter", p.jitter, Unit::none, from_to(0, 1), optional.when(is_fill, "type = fill"),
    "share of the free gap by which a particle may be moved, unused with sizes");
  v("velocity", p.velocity, Unit::speed, any_value, optional.when(is_made, "type = fill, lattice, pour"),
    "initial velocity");
  describe_pour(v, p);
  v("fixed", p.fixed, Unit::none, any_value, optional, "held in place, as if glued; of infinite mass");
  v("rotation_blocked", p.rotation_blocked, Unit::none, any_value, optional, "the particles move but never turn");
  v("temperature", p.temperature, Unit::kelvin, above_to(0, 5000), optional_else("heat.temperature"),
    "when they enter; needs [heat]");
  v("isothermal", p.isothermal, Unit::none, any_value, optional, "they keep their temperature, whatever heat flows");
  v("heating", p.heating, Unit::specific_power, any_value, optional, "power of sources of heat inside per mass");
  v.sections("motion", p.motions, optional, "moves the particles along a prescribed path, whatever they touch");
  v.section("sizes", p.sizes, optional.when(is_measured, "type = fill, pour"), "distribution of the diameters");
}

/// Held on a prescribed path or in place, whatever force acts.
inline bool is_held(const ParticlesDeck& block) { return block.fixed || !block.motions.empty(); }

}  // namespace repose
