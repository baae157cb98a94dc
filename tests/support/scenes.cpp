#include "support/scenes.h"

#include <algorithm>

#include <fmt/format.h>

namespace repose::test {
namespace {

std::string csv_of(const std::vector<Grain>& grains) {
  std::string csv = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
  for (const Grain& g : grains) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},grain\n", g.position.x, g.position.y, g.position.z, g.velocity.x,
                       g.velocity.y, g.velocity.z, g.spin.x, g.spin.y, g.spin.z, g.radius);
  }
  return csv;
}

Deck with_csv(Deck deck) {
  ParticlesDeck csv;
  csv.type = ParticlesType::csv;
  csv.file = "grains.csv";
  deck.particles.push_back(csv);
  return deck;
}

}  // namespace

Deck bare_deck(const Coefficients& c, double timestep) {
  Deck deck;
  deck.gravity = {0.0, 0.0, 0.0};
  deck.domain = {{-100.0, -100.0, -100.0}, {100.0, 100.0, 100.0}};
  deck.materials = {{"grain", c.youngs_modulus, c.poisson_ratio, c.density},
                    {"wall", c.youngs_modulus, c.poisson_ratio, c.density}};
  deck.pairs = {{{c.restitution_pp, c.sliding_pp, c.rolling_pp}, {"grain", "grain"}},
                {{c.restitution_pw, c.sliding_pw, c.rolling_pw}, {"grain", "wall"}}};
  deck.time.step = timestep;
  deck.time.expected_speed = 1.0;
  return deck;
}

Deck listed_deck(double timestep, std::int64_t steps) {
  Deck deck = with_csv(bare_deck({}, timestep));
  PhaseDeck phase;
  phase.name = "only";
  phase.until = PhaseUntil::steps;
  phase.steps = steps;
  deck.phases = {phase};
  return deck;
}

WallDeck floor_at(double height) {
  WallDeck wall;
  wall.name = "floor";
  wall.type = WallType::plane;
  wall.material = "wall";
  wall.point = {0.0, 0.0, height};
  wall.normal = {0.0, 0.0, 1.0};
  return wall;
}

Scene::Scene(Deck deck, const std::vector<Grain>& grains, VectorLevel level,
             const std::map<std::string, std::string>& files)
    : comm_(MPI_COMM_WORLD),
      simulation_(
          comm_, with_csv(std::move(deck)),
          [&](const std::string& file) { return files.contains(file) ? files.at(file) : csv_of(grains); }, level) {}

std::vector<Grain> Scene::grains() const {
  const Particles& particles = simulation_.particles();
  const auto count = static_cast<std::size_t>(simulation_.inserted());
  std::vector<double> values(10 * count, 0.0);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    double* row = &values[10 * static_cast<std::size_t>(particles.id[i])];
    const Grain g = {p.position, p.velocity, p.spin, p.radius};
    const double all[] = {g.position.x, g.position.y, g.position.z, g.velocity.x, g.velocity.y,
                          g.velocity.z, g.spin.x,     g.spin.y,     g.spin.z,     g.radius};
    std::copy(std::begin(all), std::end(all), row);
  }
  comm_.sum_elements(std::span(values.begin(), values.end()));
  std::vector<Grain> grains(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* v = &values[10 * i];
    grains[i] = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9]};
  }
  return grains;
}

}  // namespace repose::test
