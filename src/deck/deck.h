#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/vec3.h"

/// The deck as plain structs, SI units throughout. schema.h holds the key, unit, range, default and meaning of each
/// member; read_deck fills them and has checked everything that can be checked without the scene.
namespace repose {

inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();  ///< an optional number that was not given

struct RunDeck {
  std::string title;
  std::uint64_t seed = 1;
  std::int64_t check_every = 100;  ///< steps between looks at a phase's energy condition and at the discharge
};

enum class Axis { x, y, z };

/// The component of a vector along an axis.
constexpr double Vec3::*component(Axis axis) {
  return axis == Axis::x ? &Vec3::x : axis == Axis::y ? &Vec3::y : &Vec3::z;
}

struct DomainDeck {
  Vec3 min;
  Vec3 max;
  std::vector<Axis> periodic = {};  ///< directions in which the domain repeats itself
};

enum class DomainFace { x_min, x_max, y_min, y_max, z_min, z_max };

struct ExitDeck {
  std::string name;
  DomainFace face = DomainFace::z_min;
  Vec3 min{unset, unset, unset};  ///< of the part of the face; default: the domain's
  Vec3 max{unset, unset, unset};
};

struct MaterialDeck {
  std::string name;
  double youngs_modulus = unset;
  double poisson_ratio = unset;
  double density = unset;
};

struct PairDeck {
  std::array<std::string, 2> materials;
  double restitution = unset;
  double sliding_friction = unset;
  double rolling_friction = unset;
  double hooke_stiffness = unset;             ///< [contact] normal_law = hooke: k_n, N/m
  double hooke_tangential_ratio = 2.0 / 7.0;  ///< [contact] normal_law = hooke: k_t / k_n
};

enum class NormalLaw { hertz, hooke };
enum class TangentialSpring { projected, rotated };
enum class RollingHistory { fixed, rotated };

/// The defaults are the contact law of the thesis.
struct ContactDeck {
  NormalLaw normal_law = NormalLaw::hertz;
  bool attraction = true;  ///< false: the normal force never pulls, and is damped to the same restitution
  TangentialSpring tangential_spring = TangentialSpring::projected;
  RollingHistory rolling_history = RollingHistory::fixed;
};

enum class MotionType { translation, oscillation, rotation };

/// A prescribed motion of a wall or of a block of particles. It advances during its phases only.
struct MotionDeck {
  MotionType type = MotionType::translation;
  Vec3 velocity;                       ///< translation
  Vec3 amplitude;                      ///< oscillation: displacement amplitude x sin(2 pi frequency t)
  double frequency = unset;            ///< oscillation
  Vec3 axis_origin;                    ///< rotation
  Vec3 axis_direction{0.0, 0.0, 1.0};  ///< rotation
  double angular_velocity = unset;     ///< rotation, by the right-hand rule
  std::vector<std::string> phases;     ///< empty: all
};

enum class WallType { profile, plane, disc, rectangle, mesh };

struct WallDeck {
  std::string name;
  WallType type = WallType::plane;
  std::string material;
  bool present = true;                        ///< false: a phase adds it
  std::vector<std::array<double, 2>> points;  ///< profile: (r, z) along the polyline
  Vec3 axis_origin{0.0, 0.0, 0.0};            ///< profile: where z = 0
  Vec3 axis_direction{0.0, 0.0, 1.0};         ///< profile
  Vec3 point;                                 ///< plane
  Vec3 normal{0.0, 0.0, 1.0};                 ///< plane, disc
  Vec3 centre;                                ///< disc
  double radius = unset;                      ///< disc
  Vec3 corner;                                ///< rectangle
  Vec3 edge_u;                                ///< rectangle: from the corner
  Vec3 edge_v;                                ///< rectangle: from the corner, perpendicular to edge_u
  std::string file;                           ///< mesh: path relative to the deck
  double scale = 1.0;                         ///< mesh: m per unit of length of the file
  Vec3 rotate_axis{0.0, 0.0, 1.0};            ///< mesh: through the origin of the file
  double rotate_angle = 0.0;                  ///< mesh: degrees
  Vec3 translate;                             ///< mesh: after scale and rotation
  double feature_angle = 20.0;                ///< mesh: degrees; facets that turn by less are one smooth surface
  std::vector<MotionDeck> motions;            ///< [[wall.motion]], the first one applied first
};

enum class SizesType { classes, lognormal, weibull, uniform, csv };
enum class Weighting { mass, number };

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

enum class ParticlesType { fill, lattice, csv, snapshot, pour };
enum class RegionShape { cylinder, box, disc };
enum class LatticeType { simple_cubic, body_centred, face_centred };

struct ParticlesDeck {
  ParticlesType type = ParticlesType::fill;
  std::string material;                             ///< fill, lattice, pour
  double diameter = unset;                          ///< fill, lattice, pour; or sizes
  SizesDeck sizes;                                  ///< fill, pour; or diameter
  double mass = unset;                              ///< fill, pour: total mass; or count
  std::int64_t count = 0;                           ///< fill, pour: number of particles; or mass
  RegionShape region = RegionShape::cylinder;       ///< fill, lattice, pour; disc: pour
  Vec3 centre;                                      ///< cylinder: of the bottom, the axis is vertical (z); disc
  double radius = unset;                            ///< cylinder: at the bottom; disc
  double radius_top = unset;                        ///< cylinder: at the top (a cone frustum); default: radius
  double height = unset;                            ///< cylinder
  Vec3 min;                                         ///< box
  Vec3 max;                                         ///< box
  Vec3 normal{0.0, 0.0, 1.0};                       ///< disc
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
};

/// Held on a prescribed path or in place, whatever force acts.
inline bool is_held(const ParticlesDeck& block) { return block.fixed || !block.motions.empty(); }

/// Whether a file lists the particles of a block with their materials and sizes.
constexpr bool comes_from_file(ParticlesType type) {
  return type == ParticlesType::csv || type == ParticlesType::snapshot;
}

enum class Integrator { velocity_verlet, synchronised_verlet };

struct TimeDeck {
  Integrator integrator = Integrator::velocity_verlet;
  double step = unset;  ///< given time step; default: from the criteria
  double rayleigh_fraction = 0.20;
  double hertz_fraction = 0.10;
  double hooke_fraction = 0.02;
  double expected_speed = unset;  ///< default: free fall over the scene's height
};

/// The apparatus tilts: gravity turns about an axis the other way.
struct TiltDeck {
  bool enabled = false;  ///< true when the deck has the section
  Vec3 axis_direction{0.0, 1.0, 0.0};
  double angular_velocity = unset;
  std::vector<std::string> phases;  ///< empty: all
};

enum class PhaseUntil { kinetic_energy, time, steps, tilt_onset };

struct PhaseDeck {
  std::string name;
  PhaseUntil until = PhaseUntil::time;
  double kinetic_energy = unset;  ///< kinetic_energy: mean translational energy per particle to fall below
  double time = unset;            ///< time: duration of the phase
  std::int64_t steps = 0;         ///< steps: length of the phase
  double min_time = 0.0;
  double max_time = unset;  ///< ends the phase whatever its condition; required with kinetic_energy
  std::vector<std::string> remove_walls;
  std::vector<std::string> add_walls;
};

struct DischargeDeck {
  bool enabled = false;           ///< true when the deck has the section
  double orifice_height = unset;  ///< z of the orifice plane; below it counts as discharged
  double plugged_share = 0.5;     ///< less than this share of the mass discharged: plugged
};

enum class Camera { orthographic, perspective };

struct AngleOfReposeDeck {
  bool enabled = false;         ///< true when the deck has the section
  double plate_height = unset;  ///< z of the plate's surface
  double max_height = unset;    ///< z above which grains are no part of the pile; default orifice_height
  Vec3 axis;                    ///< a point on the pile's vertical axis (x and y count)
  double fit_from = 0.2;        ///< lower end of the fitted flank, share of the pile's height
  double fit_to = 0.8;
  std::int64_t azimuths = 36;  ///< number of view directions over half a turn
  Camera camera = Camera::orthographic;
  double camera_distance = unset;  ///< perspective: from the axis
  double camera_height = unset;    ///< perspective: z of the camera
};

struct ScatteringDeck {
  bool enabled = false;                                ///< true when the deck has the section
  double plate_height = unset;                         ///< z of the plate's surface
  Vec3 plate_min{unset, unset, unset};                 ///< x and y of the plate's edge; default: the domain's
  Vec3 plate_max{unset, unset, unset};                 ///< as plate_min
  double max_height = unset;                           ///< z above which grains do not count; default orifice_height
  Vec3 axis;                                           ///< a point on the vertical axis of the areas (x and y count)
  double on_plate_gap = 0.25;                          ///< of its diameter: nearer to the plate, a grain lies on it
  double ring_width = unset;                           ///< to find the base; default two median diameters
  double base_share = 0.5;                             ///< of the density under the pile, below which the base ends
  double base_radius = unset;                          ///< from which area 1 is counted; default: as measured
  double area_1_width = unset, area_3_radius = unset;  ///< of the ring next to the base; of the outermost circle
  std::vector<double> area_1_widened, area_3_widened;  ///< others to count with
};

struct TiltOnsetDeck {
  bool enabled = false;         ///< true when the deck has the section
  std::int64_t particle = 0;    ///< id
  std::string against;          ///< material of what it rests on
  double displacement = unset;  ///< that is motion; default 0.001 of its radius
  bool extrapolate = true;      ///< repeats the run at half the rate of tilt and extrapolates to none
};

struct SurfaceAngleDeck {
  bool enabled = false;  ///< true when the deck has the section
  Vec3 axis_origin;
  Vec3 axis_direction{0.0, 1.0, 0.0};
  double radius = unset;    ///< of the drum
  double from = 0.0;        ///< time of the first sample
  double interval = 0.01;   ///< time between samples
  double half_width = 0.5;  ///< of the fitted part about the drum's axis, share of its radius
};

struct OutputDeck {
  double snapshot_interval = 0.0;  ///< 0: only the snapshots at snapshot_times and at the end
  std::vector<double> snapshot_times;
  double series_interval = 0.01;
  double progress_seconds = 5.0;      ///< wall seconds between progress lines
  double checkpoint_minutes = 10.0;   ///< wall minutes between checkpoints; 0: not by time
  std::int64_t checkpoint_steps = 0;  ///< steps between checkpoints; 0: not by steps
  bool trace = false;
  std::int64_t trace_every = 10;
};

struct GuardsDeck {
  double max_overlap = 0.3;  ///< of the smaller radius
};

struct NeighboursDeck {
  double skin = 0.3;           ///< outer skin at rest, in particle radii (each particle's share)
  double inner_skin = 0.003;   ///< inner skin at rest, in particle radii
  double max_imbalance = 1.1;  ///< cost of the busiest rank over the mean that triggers rebalancing
};

struct Deck {
  RunDeck run;
  Vec3 gravity{0.0, 0.0, -9.81};
  DomainDeck domain;
  std::vector<ExitDeck> exits;          ///< [[exit]]
  std::vector<MaterialDeck> materials;  ///< [[material]]
  std::vector<PairDeck> pairs;          ///< [[pair]]
  ContactDeck contact;
  std::vector<WallDeck> walls;           ///< [[wall]]
  std::vector<ParticlesDeck> particles;  ///< [[particles]]
  TiltDeck tilt;
  TimeDeck time;
  std::vector<PhaseDeck> phases;      ///< [[phase]]
  DischargeDeck discharge;            ///< [measurement.discharge]
  AngleOfReposeDeck angle_of_repose;  ///< [measurement.angle_of_repose]
  ScatteringDeck scattering;          ///< [measurement.scattering]
  TiltOnsetDeck tilt_onset;           ///< [measurement.tilt_onset]
  SurfaceAngleDeck surface_angle;     ///< [measurement.surface_angle]
  OutputDeck output;
  GuardsDeck guards;
  NeighboursDeck neighbours;
};

}  // namespace repose
