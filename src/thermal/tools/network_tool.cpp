#include "thermal/tools/network_tool.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "base/error.h"
#include "heat/gap_conductance.h"
#include "output/snapshot_reader.h"
#include "scene/insertion/particle_csv.h"
#include "thermal/beds/bed_conductivity.h"
#include "thermal/beds/network.h"
#include "thermal/beds/temperatures.h"
#include "thermal/tool_deck.h"

namespace repose::thermal {

/// A material as heat sees it.
struct HeatMaterial {
  std::string name;
  double conductivity = 0.0;  ///< W/(m K)
  double emissivity = 0.0;
  double stiffness_ratio = 1.0;  ///< simulated over real Young's modulus
};

struct NetworkBoxDeck {
  Vec3 min;
  Vec3 max;
  Axis axis = Axis::z;
  std::vector<Axis> periodic;
};

struct NetworkDeck {
  std::string title;
  std::vector<HeatMaterial> materials;
  NetworkBoxDeck box;
  double max_gap = 1.0;
  double pressure = 101325.0;  ///< Pa
  TemperatureRange temperature;
  double shape_factor = 1.25;
  double distribution = 1.0;
  double flattening = 0.0;
};

template <class V>
void describe(V& v, HeatMaterial& m) {
  v("name", m.name, Unit::none, any_value, required, "as in the snapshot");
  v("conductivity", m.conductivity, Unit::conductivity, above(0), required, "of the solid");
  v("emissivity", m.emissivity, Unit::none, above_to(0, 1), required, "of the surface");
  v("stiffness_ratio", m.stiffness_ratio, Unit::none, above_to(0, 1), optional,
    "simulated over real Young's modulus: contacts are as wide as the real ones");
}

template <class V>
void describe(V& v, NetworkBoxDeck& b) {
  v("min", b.min, Unit::metre, any_value, required, "corner of the box in which the conductivity is measured");
  v("max", b.max, Unit::metre, any_value, required, "opposite corner");
  v("axis", b.axis, Unit::none, any_value, optional, "of the heat's way");
  v("periodic", b.periodic, Unit::none, any_value, optional, "directions in which the bed repeats itself");
}

template <class V>
void describe(V& v, NetworkDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("max_gap", d.max_gap, Unit::none, from_to(0, 2), optional, "greatest gap that conducts, over the mean radius");
  v("pressure", d.pressure, Unit::pascal, above(0), optional, "of the air");
  v("shape_factor", d.shape_factor, Unit::none, above(0), optional, "of the model: 1.25 spheres");
  v("size_distribution", d.distribution, Unit::none, above(0), optional, "of the model, f(zeta): 1 for one size");
  v("flattening", d.flattening, Unit::none, from_to_below(0, 1), optional, "of the model");
  v.sections("material", d.materials, required, "a material as heat sees it; the model is that of the first");
  v.section("box", d.box, required, "where to measure");
  v.section("temperature", d.temperature, optional, "where to evaluate");
}

namespace {

Point point_of(const Vec3& v) { return {v.x, v.y, v.z}; }
std::size_t index_of(Axis axis) { return static_cast<std::size_t>(axis); }

void check(NetworkDeck& deck, DeckErrors& errors) {
  const Point min = point_of(deck.box.min);
  const Point max = point_of(deck.box.max);
  for (std::size_t d = 0; d < 3; ++d)
    if (max[d] <= min[d]) errors.add("box.max", "each component of \"max\" of [box] must be above that of \"min\"");
  if (std::count(deck.box.periodic.begin(), deck.box.periodic.end(), deck.box.axis) > 0)
    errors.add("box.periodic", "the heat's way cannot be periodic: grains at both ends have different temperatures");
  check_range(deck.temperature, errors);
}

/// A bed as it was read, with its links.
struct LinkedBed {
  std::vector<Grain> grains;
  std::vector<Link> links;
  MeasuringBox box;
  Periods periods;
  double porosity = 0.0;
  double mean_diameter = 0.0;       ///< m
  std::size_t contacts = 0;         ///< of the links
  double contacts_per_grain = 0.0;  ///< mean coordination number
};

std::vector<Grain> grains_of(const NetworkDeck& deck, const DataFile& file) {
  std::vector<MaterialDeck> materials;
  for (const HeatMaterial& m : deck.materials) materials.push_back({.name = m.name});
  const NewParticles particles = is_snapshot(file.bytes) ? parse_snapshot(file.bytes, file.name, materials)
                                                         : parse_measured_csv(file.bytes, file.name, materials);
  std::vector<Grain> grains;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::size_t material = particles.material.empty() ? 0 : static_cast<std::size_t>(particles.material[i]);
    grains.push_back({point_of(particles.position[i]), particles.radius[i], material});
  }
  return grains;
}

/// Grains that the box cannot have: in a periodic direction it must be that of the simulation.
void check_places(const LinkedBed& bed, const std::string& file) {
  constexpr double furthest = 1e6;  // m
  for (std::size_t i = 0; i < bed.grains.size(); ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = bed.grains[i].centre[d];
      const double slack = 1e-6 * bed.periods.length[d];
      const bool is_inside = x >= bed.box.min[d] - slack && x <= bed.box.max[d] + slack;
      if (std::abs(x) > furthest || (bed.periods.length[d] > 0.0 && !is_inside)) {
        throw DeckError(
            fmt::format("{}: grain {} lies at {} = {} m, outside the box, which must be that of the bed in a "
                        "periodic direction",
                        file, i, "xyz"[d], x));
      }
    }
  }
}

LinkedBed bed_of(const NetworkDeck& deck, const DataFile& file) {
  LinkedBed bed;
  bed.grains = grains_of(deck, file);
  bed.box = {point_of(deck.box.min), point_of(deck.box.max), index_of(deck.box.axis)};
  for (const Axis axis : deck.box.periodic) {
    const std::size_t d = index_of(axis);
    bed.periods.length[d] = bed.box.max[d] - bed.box.min[d];
  }
  check_places(bed, file.name);
  bed.links = links_of(bed.grains, bed.periods, deck.max_gap);
  constexpr int lines = 200;
  bed.porosity = porosity_in(bed.grains, bed.box, bed.periods, lines);
  if (bed.porosity <= 0.0 || bed.porosity >= 1.0)
    throw DeckError(fmt::format("{}: the box has the porosity {:.3g}; it must hold a bed", file.name, bed.porosity));
  for (const Grain& g : bed.grains) bed.mean_diameter += 2.0 * g.radius / static_cast<double>(bed.grains.size());
  for (const Link& l : bed.links)
    bed.contacts += l.distance < bed.grains[l.first].radius + bed.grains[l.second].radius ? 1U : 0U;
  bed.contacts_per_grain = 2.0 * static_cast<double>(bed.contacts) / static_cast<double>(bed.grains.size());
  return bed;
}

GrainPair pair_of(const NetworkDeck& deck, const LinkedBed& bed, const Link& link) {
  const Grain& a = bed.grains[link.first];
  const Grain& b = bed.grains[link.second];
  const HeatMaterial& first = deck.materials[a.material];
  const HeatMaterial& second = deck.materials[b.material];
  const double gap = link.distance - a.radius - b.radius;
  // Compliances add: of materials that were simulated with the same modulus, a pair has the mean of their ratios.
  const double stiffness = 0.5 * (first.stiffness_ratio + second.stiffness_ratio);
  return {.radius_1 = a.radius,
          .radius_2 = b.radius,
          .conductivity_1 = first.conductivity,
          .conductivity_2 = second.conductivity,
          .gap = gap,
          .contact_radius = contact_radius(a.radius, b.radius, -gap, stiffness)};
}

/// The network at one temperature, and the model beside it.
Json row_at(const NetworkDeck& deck, const LinkedBed& bed, double temperature) {
  const Gas gas = air_at(temperature, deck.pressure);
  std::vector<double> contact;
  std::vector<double> all;
  for (const Link& link : bed.links) {
    const GrainPair pair = pair_of(deck, bed, link);
    const double emissivity_1 = deck.materials[bed.grains[link.first].material].emissivity;
    const double emissivity_2 = deck.materials[bed.grains[link.second].material].emissivity;
    const GapFill fill{.conductivity = gas.conductivity,
                       .free_path = modified_free_path(gas),
                       .radiation = radiative_coefficient(temperature, emissivity_1, emissivity_2)};
    contact.push_back(contact_conductance(pair));
    all.push_back(contact.back() + gap_conductance(pair, fill, bed.porosity));
  }
  const NetworkResult network = conduct(bed.grains, bed.links, all, bed.box, bed.periods);
  const double through_contacts = std::accumulate(contact.begin(), contact.end(), 0.0);
  const double through_all = std::accumulate(all.begin(), all.end(), 0.0);
  const HeatMaterial& material = deck.materials.front();  // the model knows one
  const double model = bed_conductivity({.porosity = bed.porosity,
                                         .diameter = bed.mean_diameter,
                                         .particle_conductivity = material.conductivity,
                                         .emissivity = material.emissivity,
                                         .shape_factor = deck.shape_factor,
                                         .distribution = deck.distribution,
                                         .flattening = deck.flattening},
                                        gas);
  return {{"temperature_K", temperature},
          {"conductivity_W_mK", network.conductivity},
          {"model_W_mK", model},
          {"difference_percent", 100.0 * (network.conductivity / model - 1.0)},
          {"contacts_share", through_all > 0.0 ? through_contacts / through_all : 0.0},
          {"heat_imbalance", network.imbalance},
          {"held_grains", network.held},
          {"free_grains", network.free},
          {"floating_grains", network.floating}};
}

std::string linked_bed_text(const Json& bed) {
  std::string text = fmt::format(
      "{}: {} grains, porosity {:.4f}, {:.2f} contacts per grain, {} near gaps\n\n"
      "| T, K | k network, W/(m K) | k model | difference | share of contacts |\n|---|---|---|---|---|\n",
      bed["file"].get<std::string>(), bed["grains"].get<std::size_t>(), bed["porosity"].get<double>(),
      bed["contacts_per_grain"].get<double>(), bed["gaps"].get<std::size_t>());
  for (const Json& r : bed["conductivity"]) {
    text += fmt::format("| {:.2f} | {:.4f} | {:.4f} | {:+.1f} % | {:.3f} |\n", r["temperature_K"].get<double>(),
                        r["conductivity_W_mK"].get<double>(), r["model_W_mK"].get<double>(),
                        r["difference_percent"].get<double>(), r["contacts_share"].get<double>());
  }
  return text + "\n";
}

}  // namespace

std::string network_keys() { return key_reference<NetworkDeck>("Keys of a file for repose thermal network."); }

ToolResult network_tool(const ToolInput& input) {
  const auto deck = read_tool_deck<NetworkDeck>(input, check);
  Json beds = Json::array();
  ToolResult result;
  for (const DataFile& file : input.files) {
    const LinkedBed bed = bed_of(deck, file);
    Json rows = Json::array();
    for (const double t : temperatures_of(deck.temperature)) rows.push_back(row_at(deck, bed, t));
    beds.push_back({{"file", file.name},
                    {"grains", bed.grains.size()},
                    {"porosity", bed.porosity},
                    {"mean_diameter_m", bed.mean_diameter},
                    {"contacts", bed.contacts},
                    {"gaps", bed.links.size() - bed.contacts},
                    {"contacts_per_grain", bed.contacts_per_grain},
                    {"model_material", deck.materials.front().name},
                    {"conductivity", rows}});
    result.text += linked_bed_text(beds.back());
  }
  result.json = {{"tool", "network"}, {"title", deck.title}, {"beds", beds}};
  return result;
}

}  // namespace repose::thermal
