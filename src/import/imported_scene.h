#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "deck/deck.h"
#include "import/script_command.h"
#include "import/units.h"

/// What the commands of a script have said, SI units throughout. Stages are counted by the runs before: what is
/// defined before the first `run` is there from stage 0 on.
namespace repose {

inline constexpr std::size_t never_removed = std::numeric_limits<std::size_t>::max();

/// A command that the deck does not hold, and why.
struct Note {
  Place place = {};
  std::string command = {};
  std::string reason = {};
};

/// "file:line: command: reason", as one line.
std::string text(const Note& note);

struct Extent {
  Vec3 min = {};
  Vec3 max = {};
};

struct ScriptRegion {
  Place place = {};
  std::string kind = {};  ///< block, cylinder; others are known by name alone
  bool is_inside = true;
  Extent block = {};  ///< INF: infinite
  char axis = 'z';    ///< cylinder
  double c1 = 0.0;    ///< cylinder: the axis across its direction, in the order of x, y, z
  double c2 = 0.0;
  double radius = 0.0;  ///< cylinder
  double low = 0.0;     ///< cylinder: along its axis
  double high = 0.0;
};

/// A grain of a list.
struct Grain {
  std::int64_t id = 0;
  int type = 1;
  double radius = 0.0;   ///< m
  double density = 0.0;  ///< kg/m3
  Vec3 position = {};
  Vec3 velocity = {};
  Vec3 spin = {};
  bool is_fixed = false;
};

/// As LAMMPS fixes it when it is defined.
struct ScriptGroup {
  bool has_all = false;
  std::set<std::int64_t> grains = {};  ///< ids of the list

  bool holds(const Grain& grain) const { return has_all || grains.contains(grain.id); }
};

/// A fix that is there.
struct ScriptFix {
  ScriptCommand command = {};
  bool is_checked = false;  ///< whether its group has been compared with the list
  bool is_noted = false;    ///< that it acts on other grains than here

  const std::string& group() const { return command.words[2]; }
  const std::string& style() const { return command.words[3]; }
};

/// `fix property/global`
struct Property {
  Place place = {};
  std::string kind = {};            ///< scalar, peratomtype, peratomtypepair, ...
  std::vector<double> values = {};  ///< of a pair type by type
};

/// `fix gravity`
struct ScriptGravity {
  Place place = {};
  Vec3 acceleration = {};
};

/// The words behind `model`.
struct ScriptModel {
  Place place = {};
  std::string normal = {};
  std::string tangential = "off";
  std::string rolling = "off";
  std::string cohesion = "off";
  bool tangential_damping = true;
  bool limit_force = false;
  bool tangential_reduce = false;
  bool kt_to_kn_user = false;
};

struct ParticleTemplate {
  Place place = {};
  int type = 1;
  double density = 1.0;
  double radius = 1.0;
};

struct ScriptDistribution {
  Place place = {};
  std::vector<std::string> templates = {};
  std::vector<double> shares = {};
  bool is_by_mass = true;
};

/// A mesh as it lies in space: x -> scale * turn(x) + shift, turns one after the other.
struct ScriptMesh {
  Place place = {};
  std::string file = {};
  int type = 1;
  double scale = 1.0;
  std::vector<std::array<double, 4>> turns = {};  ///< axis and degrees
  Vec3 shift = {};
  std::optional<MotionDeck> surface_motion = {};
  std::optional<double> temperature = {};  ///< K
  std::optional<double> feature_angle = {};
};

/// `fix wall/gran`: one primitive or meshes.
struct ScriptWall {
  Place place = {};
  std::string name = {};  ///< of the fix
  ScriptModel model = {};
  int type = 1;
  std::string shape = {};  ///< xplane, ..., zcylinder; empty: meshes
  Vec3 point = {};         ///< of a primitive: on the plane or on the axis
  Vec3 direction = {};     ///< of a primitive: the normal or the axis
  double radius = 0.0;     ///< of a cylinder
  std::optional<MotionDeck> shear = {};
  std::optional<double> temperature = {};  ///< K, of a primitive
  std::vector<std::string> meshes = {};
  std::size_t from = 0;
  std::size_t until = never_removed;
};

/// `fix move/mesh`
struct MeshMotion {
  Place place = {};
  std::string name = {};  ///< of the fix
  std::string mesh = {};
  MotionDeck motion = {};
  std::size_t from = 0;
  std::size_t until = never_removed;
};

/// `fix adapt ... atom diameter`, by a factor.
struct ScriptGrowth {
  Place place = {};
  std::string name = {};  ///< of the fix
  double factor = 1.0;
  std::int64_t every = 1;  ///< steps
  std::size_t from = 0;
  std::size_t until = never_removed;
};

/// `fix heat/gran`
struct ScriptHeat {
  Place place = {};
  double temperature = 0.0;  ///< K, of all grains at first
  bool area_correction = false;
};

/// `set ... property/atom Temp | heatSource`: of the grains in a region.
struct ScriptHeating {
  Place place = {};
  std::string region = {};                 ///< a block; empty: everywhere
  std::optional<double> temperature = {};  ///< K
  std::optional<double> power = {};        ///< W, in each grain
  std::size_t from = 0;
  std::size_t until = never_removed;
};

enum class InsertionKind { pack, stream, rate_region };

struct ScriptInsertion {
  Place place = {};
  std::string name = {};
  InsertionKind kind = InsertionKind::pack;
  std::string distribution = {};
  std::int64_t seed = 1;
  std::string region = {};            ///< pack, rate_region
  std::string face = {};              ///< stream: a mesh
  std::set<std::string> groups = {};  ///< that have its grains
  Vec3 velocity = {};
  std::optional<double> count = {};            ///< in all
  std::optional<double> mass = {};             ///< kg, in all
  std::optional<double> region_count = {};     ///< pack: that the region is to hold; or
  std::optional<double> region_mass = {};      ///< pack: kg
  std::optional<double> volume_fraction = {};  ///< pack
  std::optional<double> particle_rate = {};
  std::optional<double> mass_rate = {};
  std::int64_t every = -1;  ///< steps; 0: once, -1: not given
  std::int64_t start = 0;   ///< step, 0: at once
  bool all_in = false;      ///< whether grains are to lie wholly in the region, not just their centres
  std::size_t from = 0;
  std::size_t until = never_removed;
};

struct ScriptRun {
  Place place = {};
  std::int64_t steps = 0;
};

struct ImportedScene {
  ScriptUnits units = {};
  std::array<std::string, 3> boundary = {"p", "p", "p"};
  std::optional<Extent> box = {};
  Place box_place = {};
  int types = 0;
  bool has_restarted = false;  ///< from a dump, which need not have grains of all types
  std::map<std::string, ScriptRegion> regions = {};
  std::map<std::string, ScriptGroup> groups = {{"all", {true, {}}}};

  std::map<std::string, Property> properties = {};  ///< by the name of what they are
  std::map<std::string, ParticleTemplate> templates = {};
  std::map<std::string, ScriptDistribution> distributions = {};
  std::optional<ScriptModel> model = {};
  std::map<std::string, ScriptGravity> gravities = {};  ///< by the name of the fix; before the first run
  Vec3 gravity = {};                                    ///< all of them, from the first run on
  Place gravity_place = {};
  std::optional<double> timestep = {};
  Place timestep_place = {};

  std::map<std::string, ScriptMesh> meshes = {};
  std::vector<ScriptWall> walls = {};
  std::vector<MeshMotion> motions = {};
  std::vector<ScriptInsertion> insertions = {};
  std::set<std::string> radius_computes = {};   ///< names of `compute ... property/atom radius`
  std::set<std::string> contact_computes = {};  ///< names of `compute ... pair/gran/local | wall/gran/local`
  std::vector<ScriptGrowth> growths = {};
  std::optional<ScriptHeat> heat = {};
  std::vector<ScriptHeating> heatings = {};
  std::vector<Grain> grains = {};
  std::vector<ScriptCommand> grain_origins = {};  ///< commands that have made or changed the list
  std::vector<ScriptRun> runs = {};
  std::optional<double> dump_interval = {};    ///< s
  std::optional<double> series_interval = {};  ///< s
  bool writes_contacts = false;                ///< a dump of contacts is there
  bool writes_walls = false;                   ///< a dump of meshes is there
  std::int64_t first_step = 0;                 ///< of the counter of LIGGGHTS, when ours is 0
  bool integrates = false;                     ///< a fix nve/sphere is there in the first run

  std::map<std::string, ScriptFix> fixes = {};  ///< those that are there
  std::vector<Note> missing = {};               ///< what has no counterpart
  std::vector<Note> needless = {};              ///< what a deck need not say

  bool has_run() const { return !runs.empty(); }
  /// Whether this mesh is, or has been, a wall.
  bool has_wall_of(const std::string& mesh) const;
  std::int64_t steps() const {
    std::int64_t all = 0;
    for (const ScriptRun& run : runs) all += run.steps;
    return all;
  }
};

}  // namespace repose
