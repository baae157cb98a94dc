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

struct DomainDeck {
  Vec3 min;
  Vec3 max;
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
};

enum class ParticlesType { fill, csv };
enum class RegionShape { cylinder, box };

struct ParticlesDeck {
  ParticlesType type = ParticlesType::fill;
  std::string material;                        ///< fill
  double diameter = unset;                     ///< fill
  double mass = unset;                         ///< fill: total mass; or count
  std::int64_t count = 0;                      ///< fill: number of particles; or mass
  RegionShape region = RegionShape::cylinder;  ///< fill
  Vec3 centre;                                 ///< fill, cylinder: centre of the bottom; the axis is vertical (z)
  double radius = unset;                       ///< fill, cylinder: at the bottom
  double radius_top = unset;                   ///< fill, cylinder: at the top (a cone frustum); default: radius
  double height = unset;                       ///< fill, cylinder
  Vec3 min;                                    ///< fill, box
  Vec3 max;                                    ///< fill, box
  double spacing = unset;                      ///< fill: lattice constant; default 1.1 diameters
  double jitter = 1.0;                         ///< fill: share of the free gap that a particle may be moved by
  Vec3 velocity;                               ///< fill: initial velocity
  std::string file;                            ///< csv: path relative to the deck
};

struct TimeDeck {
  double step = unset;  ///< given time step; default: from the criteria
  double rayleigh_fraction = 0.20;
  double hertz_fraction = 0.10;
  double expected_speed = unset;  ///< default: free fall over the scene's height
};

enum class PhaseUntil { kinetic_energy, time, steps };

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

struct OutputDeck {
  double snapshot_interval = 0.0;  ///< 0: only the snapshots at snapshot_times and at the end
  std::vector<double> snapshot_times;
  double series_interval = 0.01;
  double progress_seconds = 5.0;  ///< wall seconds between progress lines
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
  std::vector<MaterialDeck> materials;   ///< [[material]]
  std::vector<PairDeck> pairs;           ///< [[pair]]
  std::vector<WallDeck> walls;           ///< [[wall]]
  std::vector<ParticlesDeck> particles;  ///< [[particles]]
  TimeDeck time;
  std::vector<PhaseDeck> phases;      ///< [[phase]]
  DischargeDeck discharge;            ///< [measurement.discharge]
  AngleOfReposeDeck angle_of_repose;  ///< [measurement.angle_of_repose]
  OutputDeck output;
  GuardsDeck guards;
  NeighboursDeck neighbours;
};

}  // namespace repose
