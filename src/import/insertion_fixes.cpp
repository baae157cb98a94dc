#include <algorithm>

#include <fmt/core.h>

#include "import/translate.h"

namespace repose {
namespace {

/// A density or radius that is not constant.
[[noreturn]] void refuse_distributed(const std::string& key, const std::string& style, const Words& words) {
  words.fail(fmt::format("a {} that is {}: {}", key, style,
                         key == "radius" ? "write [particles.sizes] by hand, or several templates of constant radius"
                                         : "only constant ones have a counterpart"));
}

/// fix particletemplate/sphere SEED atom_type N density constant D radius constant R
void particle_template(Translation& to, Words& words) {
  refuse_second(to.scene, words.command().words[1], words);
  words.integer("the seed");
  ParticleTemplate made{.place = words.place()};
  while (!words.at_end()) {
    const std::string key = words.word("a key");
    if (key == "atom_type") {
      made.type = words.type();
    } else if (key == "density" || key == "radius") {
      const std::string& style = words.word("how it is distributed");
      if (style != "constant") refuse_distributed(key, style, words);
      (key == "density" ? made.density : made.radius) = words.number(key);
    } else if (key == "volume_limit") {
      words.number(key);
    } else {
      words.fail(fmt::format("fix particletemplate/sphere: \"{}\" has no counterpart", key));
    }
  }
  made.density *= to.scene.units.density();
  made.radius *= to.scene.units.length;
  if (!(made.density > 0.0) || !(made.radius > 0.0)) words.fail("density and radius are above 0");
  to.scene.templates[words.command().words[1]] = made;
}

void refuse_template(Translation&, Words& words) {
  words.fail(fmt::format("fix {}: grains are single spheres", words.command().words[3]));
}

/// fix particledistribution/discrete SEED N TEMPLATE SHARE ...
void distribution(Translation& to, Words& words) {
  refuse_second(to.scene, words.command().words[1], words);
  words.integer("the seed");
  ScriptDistribution made{.place = words.place()};
  made.is_by_mass = words.command().words[3] != "particledistribution/discrete/numberbased";
  const std::int64_t count = words.integer("the number of templates");
  if (count < 1) words.fail("a distribution without templates");
  for (std::int64_t k = 0; k < count; ++k) {
    made.templates.push_back(words.word("a template"));
    find_item(to.scene.templates, made.templates.back(), words, "fix particletemplate/sphere");
    made.shares.push_back(words.number("its share"));
    if (!(made.shares.back() > 0.0)) words.fail("a share is above 0");
  }
  to.scene.distributions[words.command().words[1]] = made;
}

void velocity(ScriptInsertion& made, Translation& to, Words& words) {
  const std::string style = words.word("how velocities are distributed");
  made.velocity = to.scene.units.speed() * words.vector("the velocity");
  if (style == "constant") return;
  if (style != "uniform" && style != "gaussian") {
    words.fail(fmt::format("vel {}: constant, uniform and gaussian are known", style));
  }
  if (squared_norm(words.vector("the fluctuation of the velocity")) > 0.0) {
    note_missing(to.scene, words.command(), "all grains of a block enter at one velocity, here the mean");
  }
}

void omega(Translation& to, Words& words) {
  words.expect("constant");
  if (squared_norm(words.vector("the angular velocity")) > 0.0) {
    note_missing(to.scene, words.command(), "grains enter without spin");
  }
}

void every(ScriptInsertion& made, Words& words) {
  if (words.take("once")) {
    made.every = 0;
    return;
  }
  made.every = words.steps("the steps between insertions");
  if (made.every < 1) words.fail("insertions are at least a step apart");
}

std::optional<double> amount(Words& words, const std::string& key, double unit) {
  if (words.take("INF")) return {};
  const double value = words.number(key) * unit;
  if (!(value > 0.0)) words.fail(fmt::format("{} is above 0", key));
  return value;
}

/// Keys that change nothing here, with the number of their values.
const std::map<std::string, int>& needless_keys() {
  static const std::map<std::string, int> keys = {
      {"maxattempt", 1},     {"overlapcheck", 1},  {"random_distribute", 1},
      {"verbose", 1},        {"compress_tags", 1}, {"ntry_mc", 1},
      {"warn_region", 1},    {"parallel", 1},      {"check_dist_from_subdomain_border", 1},
      {"extrude_length", 1}, {"duration", 1},      {"duration_time", 1},
      {"save_template", 1},  {"check_obb", 1},
  };
  return keys;
}

void orientation(Words& words) {
  if (!words.take("constant")) {
    words.word("the orientation");
  } else {
    for (int k = 0; k < 4; ++k) words.number("the orientation");
  }
}

bool read_amount(const std::string& key, ScriptInsertion& made, Words& words, const ScriptUnits& units) {
  if (key == "nparticles") {
    made.count = amount(words, key, 1.0);
  } else if (key == "mass") {
    made.mass = amount(words, key, units.mass);
  } else if (key == "particles_in_region") {
    made.region_count = amount(words, key, 1.0);
  } else if (key == "mass_in_region") {
    made.region_mass = amount(words, key, units.mass);
  } else if (key == "volumefraction_region") {
    made.volume_fraction = amount(words, key, 1.0);
  } else if (key == "particlerate") {
    made.particle_rate = amount(words, key, 1.0 / units.time);
  } else if (key == "massrate") {
    made.mass_rate = amount(words, key, units.mass / units.time);
  } else {
    return false;
  }
  return true;
}

void read_key(const std::string& key, ScriptInsertion& made, Translation& to, Words& words) {
  if (read_amount(key, made, words, to.scene.units)) return;
  if (key == "seed") {
    made.seed = std::max<std::int64_t>(0, words.integer("the seed"));
  } else if (key == "distributiontemplate") {
    made.distribution = words.word("the distribution");
    find_item(to.scene.distributions, made.distribution, words, "fix particledistribution/discrete");
  } else if (key == "region") {
    made.region = words.word("the region");
    find_item(to.scene.regions, made.region, words, "region");
  } else if (key == "insertion_face") {
    made.face = words.word("the insertion face");
    find_item(to.scene.meshes, made.face, words, "mesh");
  } else if (key == "insert_every" || key == "every") {
    every(made, words);
  } else if (key == "start") {
    made.start = words.steps("the first step") - to.scene.first_step;
  } else if (key == "vel") {
    velocity(made, to, words);
  } else if (key == "omega") {
    omega(to, words);
  } else if (key == "all_in") {
    made.all_in = words.choice(key);
  } else if (key == "orientation") {
    orientation(words);
  } else if (key == "set_property") {
    note_missing(to.scene, words.command(), "grains have no other properties");
    words.word("the property");
    words.word("its value");
  } else if (!words.skip_needless(key, needless_keys())) {
    words.fail(fmt::format("fix {}: \"{}\" has no counterpart", words.command().words[3], key));
  }
}

void check(const ScriptInsertion& made, Words& words) {
  const std::string& style = words.command().words[3];
  if (made.distribution.empty()) words.fail(fmt::format("fix {} lacks \"distributiontemplate\"", style));
  if (made.kind == InsertionKind::stream ? made.face.empty() : made.region.empty()) {
    words.fail(
        fmt::format("fix {} lacks \"{}\"", style, made.kind == InsertionKind::stream ? "insertion_face" : "region"));
  }
  if (made.kind != InsertionKind::pack && !made.particle_rate && !made.mass_rate) {
    words.fail(fmt::format("fix {} lacks \"particlerate\" or \"massrate\"", style));
  }
  if (made.kind == InsertionKind::pack && !made.region_count && !made.region_mass && !made.volume_fraction) {
    words.fail("fix insert/pack lacks \"particles_in_region\", \"mass_in_region\" or \"volumefraction_region\"");
  }
}

/// Those of the fix, of its distribution and of their templates (FixTemplateSphere::randomize_ptilist).
std::set<std::string> groups_of(const ScriptInsertion& made, const ImportedScene& scene, const Words& words) {
  std::set<std::string> groups = {"all", words.command().words[2]};
  std::vector<std::string> fixes = scene.distributions.at(made.distribution).templates;
  fixes.push_back(made.distribution);
  for (const std::string& name : fixes) {
    const auto found = scene.fixes.find(name);
    if (found != scene.fixes.end()) groups.insert(found->second.group());
  }
  return groups;
}

template <InsertionKind kind>
void insertion(Translation& to, Words& words) {
  ScriptInsertion made{.place = words.place(), .name = words.command().words[1], .kind = kind};
  made.from = to.scene.runs.size();
  while (!words.at_end()) {
    const std::string key = words.word("a key");
    read_key(key, made, to, words);
  }
  check(made, words);
  made.groups = groups_of(made, to.scene, words);
  to.scene.insertions.push_back(std::move(made));
}

void refuse_insertion(Translation&, Words& words) {
  words.fail(fmt::format("fix {}: insert/pack, insert/stream and insert/rate/region have a counterpart",
                         words.command().words[3]));
}

}  // namespace

const Translations& insertion_fixes() {
  static const Translations fixes = {
      {"particletemplate/sphere", particle_template},
      {"particletemplate/multisphere", refuse_template},
      {"particletemplate/superquadric", refuse_template},
      {"particletemplate/convexhull", refuse_template},
      {"particledistribution/discrete", distribution},
      {"particledistribution/discrete/massbased", distribution},
      {"particledistribution/discrete/numberbased", distribution},
      {"insert/pack", insertion<InsertionKind::pack>},
      {"insert/stream", insertion<InsertionKind::stream>},
      {"insert/rate/region", insertion<InsertionKind::rate_region>},
      {"pour", refuse_insertion},
      {"pour/dev", refuse_insertion},
      {"pour/legacy", refuse_insertion},
      {"insert/stream/moving", refuse_insertion},
  };
  return fixes;
}

}  // namespace repose
