#include "import/law_sections.h"

#include <array>

#include <fmt/core.h>

namespace repose {
namespace {

constexpr double shear_of_normal = 2.0 / 7.0;  // ktToKnUser on

const Property& property(const ImportedScene& scene, const std::string& name) {
  const auto found = scene.properties.find(name);
  if (found == scene.properties.end()) {
    refuse(scene.model->place, fmt::format("the model needs fix property/global {}, which is not there", name));
  }
  return found->second;
}

double of_type(const ImportedScene& scene, const std::string& name, int type) {
  const Property& known = property(scene, name);
  if (known.kind == "scalar" && known.values.size() == 1) return known.values[0];
  if (known.values.size() != static_cast<std::size_t>(scene.types)) {
    refuse(known.place, fmt::format("{} values of {} for {} types", known.values.size(), name, scene.types));
  }
  return known.values[static_cast<std::size_t>(type - 1)];
}

double of_pair(const ImportedScene& scene, const std::string& name, int a, int b) {
  const Property& known = property(scene, name);
  if (known.kind == "scalar" && known.values.size() == 1) return known.values[0];
  const auto types = static_cast<std::size_t>(scene.types);
  if (known.values.size() != types * types) {
    refuse(known.place, fmt::format("{} values of {} for {} pairs of types", known.values.size(), name, types * types));
  }
  const auto value = [&](int row, int column) {
    return known.values[static_cast<std::size_t>(row - 1) * types + static_cast<std::size_t>(column - 1)];
  };
  if (value(a, b) != value(b, a)) {
    refuse(known.place, fmt::format("{} of types {} and {} is {}, of {} and {} it is {}: the matrix must be symmetric",
                                    name, a, b, value(a, b), b, a, value(b, a)));
  }
  return value(a, b);
}

bool has_stiffnesses(const ScriptModel& model) { return model.normal == "hooke/stiffness"; }

std::set<std::string> thermal_properties(const ScriptHeat& heat) {
  std::set<std::string> names = {"thermalConductivity", "thermalCapacity"};
  if (heat.area_correction) names.insert("youngsModulusOriginal");
  return names;
}

/// What `fix heat/gran` knows of a type.
void write_thermal(DeckText& deck, const ImportedScene& scene, int type) {
  for (const std::string& name : thermal_properties(*scene.heat)) {
    if (!scene.properties.contains(name))
      refuse(scene.heat->place, fmt::format("fix heat/gran needs fix property/global {}, which is not there", name));
  }
  const auto key = [&](const char* name, const char* property_name, double unit) {
    deck.key(name, of_type(scene, property_name, type) * unit, text(property(scene, property_name).place));
  };
  key("conductivity", "thermalConductivity", scene.units.conductivity());
  key("specific_heat", "thermalCapacity", scene.units.specific_heat());
  if (!scene.heat->area_correction) return;
  const double ratio = of_type(scene, "youngsModulus", type) / of_type(scene, "youngsModulusOriginal", type);
  deck.key("stiffness_ratio", ratio, text(property(scene, "youngsModulusOriginal").place));
}

void write_material(DeckText& deck, const ImportedScene& scene, const MaterialUsed& material) {
  const bool is_needed = !has_stiffnesses(*scene.model);
  const auto constant = [&](const std::string& name, double unit, double otherwise) {
    if (!is_needed && !scene.properties.contains(name)) return otherwise;
    return of_type(scene, name, material.type) * unit;
  };
  deck.section("[[material]]", material.place);
  deck.key("name", material.name);
  deck.key("youngs_modulus", constant("youngsModulus", scene.units.pressure(), 1e7),
           is_needed ? text(property(scene, "youngsModulus").place) : "not used: the pairs have stiffnesses");
  deck.key("poisson_ratio", constant("poissonsRatio", 1.0, 0.3),
           is_needed ? text(property(scene, "poissonsRatio").place) : "not used");
  if (material.is_of_grains) {
    deck.key("density", material.density);
  } else {
    deck.key("density", material.density, "of walls: not used");
  }
  if (scene.heat) write_thermal(deck, scene, material.type);
}

/// What a pair of materials does, by both of them.
struct PairParts {
  bool slides, coheres, rolls;
};

PairParts parts(const ScriptModel& pair, const MaterialUsed& a, const MaterialUsed& b) {
  const MaterialUsed* wall = !a.is_of_grains ? &a : !b.is_of_grains ? &b : nullptr;
  if (wall != nullptr) return {wall->slides, wall->coheres, wall->rolls};
  return {pair.tangential != "off", pair.cohesion != "off", pair.rolling != "off"};
}

void write_pair(DeckText& deck, const ImportedScene& scene, const ScriptModel& model, const MaterialUsed& a,
                const MaterialUsed& b) {
  const PairParts has = parts(*scene.model, a, b);
  const auto key = [&](const char* name, const std::string& property_name, double unit) {
    deck.key(name, of_pair(scene, property_name, a.type, b.type) * unit, text(property(scene, property_name).place));
  };
  deck.section("[[pair]]");
  deck.key("materials", std::array<std::string, 2>{a.name, b.name});
  if (has_stiffnesses(model)) {
    key("hooke_stiffness", "kn", scene.units.stiffness());
    deck.key("hooke_tangential_ratio", of_pair(scene, "kt", a.type, b.type) / of_pair(scene, "kn", a.type, b.type),
             text(property(scene, "kt").place));
    key("hooke_damping_rate", "gamman", 1.0 / scene.units.time);
    if (model.tangential_damping) {
      key("hooke_tangential_damping_rate", "gammat", 1.0 / scene.units.time);
    } else {
      deck.key("hooke_tangential_damping_rate", 0.0);
    }
  } else {
    key("restitution", "coefficientRestitution", 1.0);
  }
  if (model.normal == "hooke") deck.key("hooke_tangential_ratio", model.kt_to_kn_user ? shear_of_normal : 1.0);
  if (has.slides) {
    key("sliding_friction", "coefficientFriction", 1.0);
  } else {
    deck.key("sliding_friction", 0.0, "tangential off");
  }
  if (has.rolls) {
    key("rolling_friction", "coefficientRollingFriction", 1.0);
    if (model.rolling == "epsd") key("rolling_viscous_damping", "coefficientRollingViscousDamping", 1.0);
  } else {
    deck.key("rolling_friction", 0.0, "rolling_friction off");
  }
  if (has.coheres) {
    key("cohesion_energy_density", "cohesionEnergyDensity", scene.units.pressure());
  } else if (model.cohesion != "off") {
    deck.key("cohesion_energy_density", 0.0, "cohesion off");
  }
}

}  // namespace

void write_materials(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials) {
  for (const MaterialUsed& material : materials.all()) write_material(deck, scene, material);
  for (std::size_t i = 0; i < materials.all().size(); ++i) {
    for (std::size_t j = i; j < materials.all().size(); ++j) {
      const MaterialUsed& a = materials.all()[i];
      const MaterialUsed& b = materials.all()[j];
      if (a.is_of_grains || b.is_of_grains) write_pair(deck, scene, materials.model(), a, b);
    }
  }
}

std::set<std::string> properties_of(const ImportedScene& scene, const ScriptModel& model) {
  std::set<std::string> names = {"youngsModulus", "poissonsRatio"};
  if (scene.heat) names.merge(thermal_properties(*scene.heat));
  if (has_stiffnesses(model)) {
    names.insert({"kn", "kt", "gamman", "gammat"});
  } else {
    names.insert("coefficientRestitution");
  }
  if (model.normal == "hooke") names.insert("characteristicVelocity");
  if (model.tangential != "off") names.insert("coefficientFriction");
  if (model.rolling != "off") names.insert("coefficientRollingFriction");
  if (model.rolling == "epsd") names.insert("coefficientRollingViscousDamping");
  if (model.cohesion != "off") names.insert("cohesionEnergyDensity");
  return names;
}

void write_heat(DeckText& deck, ImportedScene& scene, const ScriptModel& model) {
  if (!scene.heat) return;
  deck.section("[heat]", scene.heat->place);
  deck.key("temperature", scene.heat->temperature);
  deck.key("conductance", "intersection");
  deck.key("every", std::int64_t{1}, "as in LIGGGHTS; more is faster");
  if (scene.heat->area_correction && model.normal != "hertz") {
    scene.missing.push_back({scene.heat->place, "fix heat/gran", "area_correction is that of Hertz's contacts"});
  }
}

void write_contact(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials) {
  const ScriptModel& model = materials.model();
  deck.section("[contact]", model.place);
  deck.key("normal_law", model.normal == "hertz" ? "hertz" : "hooke");
  if (model.kt_to_kn_user && model.normal != "hooke")
    refuse(model.place, "ktToKnUser on has a counterpart with model hooke alone");
  if (model.normal == "hooke") {
    const Property& velocity = property(scene, "characteristicVelocity");
    deck.key("hooke_characteristic_velocity", velocity.values[0] * scene.units.speed(), text(velocity.place));
  }
  if (model.tangential == "no_history") deck.key("tangential_spring", "none");
  if (!model.tangential_damping) {
    deck.key("tangential_damping", "none");
  } else if (model.normal == "hooke") {
    deck.key("tangential_damping", "normal");
  }
  if (model.limit_force) {
    deck.key("attraction", false);
    deck.key("restitution_correction", false);
  }
  if (model.rolling != "off") deck.key("rolling_model", model.rolling);
  if (model.cohesion != "off") {
    deck.key("cohesion", model.cohesion);
    if (model.tangential_reduce) deck.key("cohesion_in_friction", true);
  }
}

}  // namespace repose
