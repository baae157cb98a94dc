#include "import/run_sections.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

#include "import/wall_motions.h"

namespace repose {
namespace {

double most_speed(const ImportedScene& scene) {
  double speed = 0.0;
  for (const ScriptInsertion& insertion : scene.insertions) speed = std::max(speed, norm(insertion.velocity));
  for (const Grain& grain : scene.grains) speed = std::max(speed, norm(grain.velocity));
  return speed;
}

/// A number of two digits that is not below, up to rounding.
double rounded_up(double value) {
  if (!(value > 0.0)) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  const std::string digits = fmt::format("{:.2g}", std::ceil(value / unit) * unit);
  return std::strtod(digits.c_str(), nullptr);
}

/// Greatest speed to be expected: that of the grains after a fall over the box, or that of a wall.
double expected_speed(const ImportedScene& scene) {
  const Vec3 size = scene.box->max - scene.box->min;
  const Vec3& g = scene.gravity;
  const double fall = std::fabs(g.x) * size.x + std::fabs(g.y) * size.y + std::fabs(g.z) * size.z;
  const double speed = most_speed(scene);
  const double driven = greatest_wall_speed(scene);
  return rounded_up(std::max({std::sqrt(speed * speed + 2.0 * fall), driven, 1e-3}));
}

void write_heating(DeckText& deck, const ImportedScene& scene, const ScriptHeating& heating, const Extent& domain) {
  const Extent region = heating.region.empty() ? domain : scene.regions.at(heating.region).block;
  const auto inside = [](const Vec3& x, const Extent& box) {
    return Vec3{std::clamp(x.x, box.min.x, box.max.x), std::clamp(x.y, box.min.y, box.max.y),
                std::clamp(x.z, box.min.z, box.max.z)};
  };
  deck.section("[[phase.heat]]", heating.place);
  deck.key("min", inside(region.min, domain));
  deck.key("max", inside(region.max, domain));
  if (heating.temperature) deck.key("temperature", *heating.temperature);
  if (heating.power) deck.key("power", *heating.power);
}

}  // namespace

Extent domain_of(const ImportedScene& scene) {
  Extent domain = *scene.box;
  const double time = static_cast<double>(scene.steps()) * *scene.timestep;
  const double reach =
      rounded_up(norm(domain.max - domain.min) + most_speed(scene) * time + 0.5 * norm(scene.gravity) * time * time);
  const std::array<double Vec3::*, 3> components = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string& side = scene.boundary.at(k);
    const auto grows = [](char c) { return c == 'm' || c == 's'; };
    if (grows(side.front())) domain.min.*components.at(k) -= reach;
    if (grows(side.back())) domain.max.*components.at(k) += reach;
  }
  return domain;
}

void write_domain(DeckText& deck, const ImportedScene& scene, const Extent& domain) {
  deck.section("[domain]", scene.box_place);
  deck.key("min", domain.min);
  deck.key("max", domain.max);
  std::vector<std::string> periodic;
  for (std::size_t k = 0; k < 3; ++k) {
    if (scene.boundary.at(k) == "p") periodic.push_back(std::string(1, "xyz"[k]));
  }
  if (!periodic.empty()) deck.key("periodic", periodic);
}

void write_time(DeckText& deck, const ImportedScene& scene, const TimeShares& shares) {
  const TimeDeck usual;
  const auto share = [&](const char* name, double value, double usual_value, const char* so) {
    if (value > usual_value)
      deck.key(name, value, fmt::format("more than {}, as the time step needs it{}", usual_value, so));
  };
  deck.section("[time]", scene.timestep_place);
  deck.key("step", *scene.timestep);
  deck.key("expected_speed", expected_speed(scene));
  share("rayleigh_fraction", shares.rayleigh, usual.rayleigh_fraction, "; beds may not come to rest");
  share("hertz_fraction", shares.hertz, usual.hertz_fraction, "; beds may not come to rest");
  share("hooke_fraction", shares.hooke, usual.hooke_fraction, "");
}

void write_phases(DeckText& deck, const ImportedScene& scene, const WallNames& walls, const Extent& domain) {
  for (std::size_t run = 0; run < scene.runs.size(); ++run) {
    std::vector<std::string> add;
    std::vector<std::string> remove;
    for (const WallPresence& wall : walls.present) {
      if (wall.from == run && run > 0) add.push_back(wall.name);
      if (wall.until == run) remove.push_back(wall.name);
    }
    deck.section("[[phase]]", scene.runs[run].place);
    deck.key("name", phase_name(run));
    deck.key("until", "steps");
    deck.key("steps", scene.runs[run].steps);
    if (!remove.empty()) deck.key("remove_walls", remove);
    if (!add.empty()) deck.key("add_walls", add);
    for (const ScriptGrowth& growth : scene.growths) {
      if (growth.from > run || run >= growth.until) continue;
      deck.section("[phase.growth]", growth.place);
      deck.key("factor", growth.factor);
      deck.key("every", growth.every);
    }
    for (const ScriptHeating& heating : scene.heatings) {
      if (heating.from <= run && run < heating.until) write_heating(deck, scene, heating, domain);
    }
  }
}

/// LIGGGHTS lets grains overlap as much as they do.
void write_guards(DeckText& deck) {
  deck.section("[guards]");
  deck.key("max_overlap", 0.5, "the most there is; LIGGGHTS has no such bound");
}

void write_output(DeckText& deck, const ImportedScene& scene) {
  if (!scene.dump_interval && !scene.series_interval && !scene.writes_contacts && !scene.writes_walls) return;
  const char* when =
      scene.dump_interval ? "beside each snapshot" : "at the end alone: no dump of grains says how often";
  deck.section("[output]");
  if (scene.dump_interval) deck.key("snapshot_interval", *scene.dump_interval, "dump");
  if (scene.series_interval) deck.key("series_interval", *scene.series_interval, "thermo");
  if (scene.writes_contacts) deck.key("contacts", true, fmt::format("dump local; {}", when));
  if (scene.writes_walls) deck.key("walls", true, fmt::format("dump mesh; {}", when));
}

}  // namespace repose
