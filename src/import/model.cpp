#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "import/translate.h"

namespace repose {
namespace {

template <std::size_t n>
std::string one_of(Words& words, const std::string& part, const std::array<std::string_view, n>& known) {
  const std::string& name = words.word("the " + part + " model");
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  std::string names;
  for (const std::string_view other : known) names += fmt::format("{}{}", names.empty() ? "" : ", ", other);
  words.fail(fmt::format("{} model \"{}\" has no counterpart; known are {}", part, name, names));
}

/// A part of the model that is no setting.
bool read_part(Words& words, ScriptModel& model) {
  if (words.take("model")) {
    model.normal = one_of<3>(words, "normal", {"hertz", "hooke", "hooke/stiffness"});
  } else if (words.take("tangential")) {
    model.tangential = one_of<3>(words, "tangential", {"history", "no_history", "off"});
  } else if (words.take("rolling_friction")) {
    model.rolling = one_of<4>(words, "rolling friction", {"cdt", "epsd", "epsd2", "off"});
  } else if (words.take("cohesion")) {
    model.cohesion = one_of<3>(words, "cohesion", {"sjkr", "sjkr2", "off"});
  } else if (words.take("surface")) {
    one_of<1>(words, "surface", {"default"});
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool read_setting(Words& words, ScriptModel& model) {
  if (words.take("tangential_damping")) {
    model.tangential_damping = words.choice("tangential_damping");
  } else if (words.take("limitForce")) {
    model.limit_force = words.choice("limitForce");
  } else if (words.take("tangential_reduce")) {
    model.tangential_reduce = words.choice("tangential_reduce");
  } else if (words.take("ktToKnUser")) {
    model.kt_to_kn_user = words.choice("ktToKnUser");
  } else {
    for (const std::string_view refused : {"absolute_damping", "torsionTorque", "viscous", "torsion_torque"}) {
      if (!words.take(refused)) continue;
      if (words.choice(refused)) words.fail(fmt::format("{} on has no counterpart", refused));
      return true;
    }
    for (const std::string_view needless : {"computeDissipatedEnergy", "computeElasticPotential",
                                            "heating_normal_hertz", "heating_tangential_history", "store_local"}) {
      if (!words.take(needless)) continue;
      words.choice(needless);
      return true;
    }
    return false;
  }
  return true;
}

ScriptModel read_model(Words& words) {
  ScriptModel model{.place = words.place()};
  while (!words.at_end()) {
    if (!read_part(words, model) && !read_setting(words, model)) break;
  }
  if (model.normal.empty())
    words.fail("the words of a contact model begin with: model hertz, hooke or hooke/stiffness");
  return model;
}

void translate_pair_style(Translation& to, Words& words) {
  const std::string& style = words.word("the pair style");
  if (style != "gran") {
    words.fail(fmt::format(
        "pair_style {}: only gran, with the words of its models (model hertz ...), has a counterpart", style));
  }
  if (to.scene.has_run() && to.scene.model) {
    return note_missing(to.scene, words.command(), "the contact model stays as it is in the first run");
  }
  to.scene.model = read_model(words);
  if (!words.at_end()) words.fail(fmt::format("\"{}\" has no counterpart", words.word("")));
}

}  // namespace repose
