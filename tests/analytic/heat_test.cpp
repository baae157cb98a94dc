// Heat between grains and from walls against LIGGGHTS's fix heat/gran and closed forms.
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "heat/conductance.h"
#include "heat/gap_conductance.h"
#include "heat/gas.h"
#include "scene/particles/sphere_mass.h"
#include "simulation/phases.h"
#include "support/liggghts_trace.h"

namespace repose::test {
namespace {

constexpr double radius = 220e-6;
constexpr double density = 3592.0;

/// Grains that stay where they are.
Deck still_deck(double conductivity, double specific_heat, double timestep) {
  Deck deck = bare_deck({.youngs_modulus = 5e6, .density = density}, timestep);
  deck.heat.enabled = true;
  deck.heat.every = 1;
  for (MaterialDeck& m : deck.materials) {
    m.conductivity = conductivity;
    m.specific_heat = specific_heat;
    m.emissivity = 0.8;
  }
  PhaseDeck rest;
  rest.name = "rest";
  rest.until = PhaseUntil::steps;
  rest.steps = 1;
  rest.mechanics = false;
  deck.phases = {rest};
  return deck;
}

/// Grains that are a block each, with a temperature of its own.
class WarmScene {
 public:
  using Change = std::function<void(std::vector<ParticlesDeck>&)>;

  WarmScene(Deck deck, const std::vector<Vec3>& centres, const std::vector<double>& temperatures,
            const Change& change = {})
      : comm_(MPI_COMM_WORLD),
        simulation_(comm_, with_blocks(std::move(deck), temperatures, change), reader(centres), best_vector_level()) {}

  Simulation& simulation() { return simulation_; }
  /// Steps of one thermal step each, in a phase that stands still.
  void rest(std::int64_t thermal_steps) {
    simulation_.begin_phase("rest");
    simulation_.advance(thermal_steps * simulation_.deck().heat.every);
  }
  double temperature(std::int64_t id) const {
    const Particles& particles = simulation_.particles();
    for (std::size_t i = 0; i < particles.owned; ++i) {
      if (particles.id[i] == id) return simulation_.heat()->state().temperature(particles, i);
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static Deck with_blocks(Deck deck, const std::vector<double>& temperatures, const Change& change) {
    for (std::size_t k = 0; k < temperatures.size(); ++k) {
      ParticlesDeck block;
      block.type = ParticlesType::csv;
      block.file = std::to_string(k);
      block.temperature = temperatures[k];
      deck.particles.push_back(block);
    }
    if (change) change(deck.particles);
    return deck;
  }
  static ReadFile reader(const std::vector<Vec3>& centres) {
    return [centres](const std::string& file) {
      const Vec3& x = centres.at(std::stoul(file));
      return fmt::format("x,y,z,radius,material\n{:.17g},{:.17g},{:.17g},{:.17g},grain\n", x.x, x.y, x.z, radius);
    };
  }

  Communicator comm_;
  Simulation simulation_;
};

/// Centres of a row along x whose surfaces are `gap` m apart; below 0 they overlap.
std::vector<Vec3> row(std::size_t count, double gap) {
  std::vector<Vec3> centres;
  for (std::size_t i = 0; i < count; ++i)
    centres.push_back({static_cast<double>(i) * (2.0 * radius + gap), 0.0, radius});
  return centres;
}

TEST(Heat, FollowsThreeSpheresOfLiggghts) {
  const std::string base = std::string(REPOSE_SOURCE_DIR) + "/tests/reference/liggghts_models/heat_three_spheres";
  std::ifstream parameters(base + ".json");
  const nlohmann::json j = nlohmann::json::parse(parameters);
  Deck deck = bare_deck(coefficients_of(j), j["dt"]);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.walls.push_back(floor_at(0.0));
  deck.heat.enabled = true;
  deck.heat.every = 1;
  deck.heat.conductance = ContactConductance::intersection;
  for (MaterialDeck& m : deck.materials) {
    m.conductivity = j["heat"]["k"];
    m.specific_heat = j["heat"]["c"];
  }
  std::vector<Vec3> centres;
  std::vector<double> temperatures;
  for (const auto& p : j["particles"]) {
    ASSERT_EQ(p["r"].get<double>(), radius);
    centres.push_back({p["x"][0], p["x"][1], p["x"][2]});
    temperatures.push_back(j["heat"]["T"][temperatures.size()]);
  }
  WarmScene scene(deck, centres, temperatures);

  std::ifstream file(base + ".csv");
  std::string line;
  std::getline(file, line);
  double worst = 0.0;
  int rows = 0;
  while (std::getline(file, line)) {
    const std::int64_t step = std::stoll(line);
    const std::int64_t id = std::stoll(line.substr(line.find(',') + 1)) - 1;
    const double theirs = std::stod(line.substr(line.rfind(',') + 1));
    if (step > scene.simulation().steps()) scene.simulation().advance(step - scene.simulation().steps());
    const double ours = scene.temperature(id);
    ASSERT_TRUE(std::isfinite(ours)) << id;
    worst = std::max(worst, std::abs(ours / theirs - 1.0));
    ++rows;
  }
  EXPECT_GT(rows, 600);
  EXPECT_LT(worst, 1e-9);
  std::cout << "  greatest relative deviation of a temperature: " << worst << "\n";
}

TEST(Heat, TwoGrainsRelaxWithTheirTimeConstant) {
  constexpr double k = 2.0, c = 800.0, overlap = 2e-6;
  const double mass = sphere_mass(radius, density);
  const double conductance = 2.0 * k * std::sqrt(0.5 * radius * overlap);
  const double time_constant = 0.5 * mass * c / conductance;
  Deck deck = still_deck(k, c, 1e-6);
  deck.heat.every = 1000;
  WarmScene scene(deck, row(2, -overlap), std::vector<double>{300.0, 400.0});
  scene.rest(200);
  scene.simulation().check_guards();
  const double time = 0.2;
  ASSERT_GT(time, time_constant / 20.0);
  // Explicit steps of 1 ms: exactly (1 - dt/tau)^n.
  const double left = std::pow(1.0 - 1e-3 / time_constant, 200.0);
  EXPECT_NEAR(scene.temperature(1) - scene.temperature(0), 100.0 * left, 1e-9);
  EXPECT_NEAR(left, std::exp(-time / time_constant), 2e-3);
  EXPECT_NEAR(scene.temperature(1) + scene.temperature(0), 700.0, 1e-9);
}

TEST(Heat, ATableOfSpecificHeatsKeepsTheEnergy) {
  Deck deck = still_deck(2.0, 800.0, 1e-6);
  for (MaterialDeck& m : deck.materials) {
    m.heat_table.enabled = true;
    m.heat_table.temperatures = {300.0, 500.0, 900.0};
    m.heat_table.conductivities = {2.0, 3.0, 1.0};
    m.heat_table.specific_heats = {700.0, 1100.0, 900.0};
  }
  deck.heat.every = 1000;
  WarmScene scene(deck, row(2, -2e-6), std::vector<double>{250.0, 1000.0});
  scene.rest(60000);
  scene.simulation().check_guards();
  // Specific energies by trapezia from 0 K: half of their sum belongs to the temperature that both come to.
  const double at_300 = 700.0 * 300.0;
  const double at_500 = at_300 + 900.0 * 200.0;
  const double at_900 = at_500 + 1000.0 * 400.0;
  const double mean = 0.5 * (700.0 * 250.0 + at_900 + 900.0 * 100.0);
  ASSERT_GT(mean, at_500);
  const double rest = mean - at_500;  // 1100 x - 0.25 x^2 = rest
  const double x = (1100.0 - std::sqrt(1100.0 * 1100.0 - rest)) / 0.5;
  EXPECT_NEAR(scene.temperature(0), 500.0 + x, 1e-6);
  EXPECT_NEAR(scene.temperature(1), 500.0 + x, 1e-6);
}

TEST(Heat, AHotFloorHeatsAGrainExponentially) {
  constexpr double k = 2.0, c = 800.0, overlap = 2e-6;
  Deck deck = still_deck(k, c, 1e-6);
  deck.heat.every = 1000;
  deck.walls.push_back(floor_at(overlap));
  deck.walls[0].heat.enabled = true;
  deck.walls[0].heat.temperature = 500.0;
  WarmScene scene(deck, row(1, 0.0), std::vector<double>{300.0});
  scene.rest(300);
  const double conductance = 2.0 * k * std::sqrt(radius * overlap);
  const double rate = conductance / (sphere_mass(radius, density) * c);
  EXPECT_NEAR(500.0 - scene.temperature(0), 200.0 * std::pow(1.0 - 1e-3 * rate, 300.0), 1e-9);
}

TEST(Heat, AWallGivesItsPowerAndOneWithACoefficientItsHeatFromOutside) {
  constexpr double k = 2.0, c = 800.0, overlap = 2e-6;
  const double mass = sphere_mass(radius, density);
  for (const bool by_power : {true, false}) {
    Deck deck = still_deck(k, c, 1e-6);
    deck.heat.every = 1000;
    deck.walls.push_back(floor_at(overlap));
    WallHeatDeck& heat = deck.walls[0].heat;
    heat.enabled = true;
    heat.type = by_power ? WallHeatType::power : WallHeatType::ambient;
    heat.power = 3e-3;
    heat.temperature = 500.0;
    heat.coefficient = 1e-5;
    WarmScene scene(deck, row(1, 0.0), std::vector<double>{300.0});
    scene.rest(100);
    if (by_power) {
      EXPECT_NEAR(scene.temperature(0), 300.0 + 3e-3 * 0.1 / (mass * c), 1e-9);
      continue;
    }
    const double contact = 2.0 * k * std::sqrt(radius * overlap);
    const double both = 1.0 / (1.0 / contact + 1.0 / heat.coefficient);
    EXPECT_NEAR(500.0 - scene.temperature(0), 200.0 * std::pow(1.0 - 1e-3 * both / (mass * c), 100.0), 1e-9);
  }
}

// Up and down again in 100 thermal steps of 1 ms; what flows in one is by the factor at its end.
TEST(Heat, AWallFollowsTheCourseOfItsFactors) {
  constexpr double k = 2.0, c = 800.0, overlap = 2e-6;
  const double heat_capacity = sphere_mass(radius, density) * c;
  const double contact = 2.0 * k * std::sqrt(radius * overlap);
  for (const WallHeatType type : {WallHeatType::power, WallHeatType::temperature, WallHeatType::ambient}) {
    Deck deck = still_deck(k, c, 1e-6);
    deck.heat.every = 1000;
    deck.walls.push_back(floor_at(overlap));
    WallHeatDeck& heat = deck.walls[0].heat;
    heat.enabled = true;
    heat.type = type;
    heat.power = 3e-3;
    heat.temperature = 500.0;
    heat.coefficient = 1e-5;
    heat.times = {0.0, 0.05, 0.1};
    heat.factors = {0.5, 2.5, 0.5};
    WarmScene scene(deck, row(1, 0.0), std::vector<double>{300.0});
    const double conductance = type == WallHeatType::ambient ? 1.0 / (1.0 / contact + 1.0 / heat.coefficient) : contact;
    double expected = 300.0;
    const auto follow = [&](int from, int to) {
      for (int n = from; n < to; ++n) {
        const double factor = 0.5 + 2.0 * (1.0 - std::abs(n + 1 - 50) / 50.0);
        const double watts = type == WallHeatType::power ? 3e-3 * factor : conductance * (500.0 * factor - expected);
        expected += 1e-3 * watts / heat_capacity;
      }
    };
    scene.rest(50);
    follow(0, 50);
    EXPECT_NEAR(scene.temperature(0), expected, 1e-9);
    scene.rest(50);
    follow(50, 100);
    EXPECT_NEAR(scene.temperature(0), expected, 1e-9);
  }
}

// The wall conducts by its own temperature, 50 K above that of the grain: k(350 K) = 3 W/(m K), k(300 K) = 2.
TEST(Heat, AWallWithoutHeatCapacityConductsAtItsOwnTemperature) {
  constexpr double overlap = 2e-6;
  for (const bool by_power : {true, false}) {
    Deck deck = still_deck(2.0, 800.0, 1e-6);
    for (MaterialDeck& m : deck.materials) {
      m.heat_table.enabled = true;
      m.heat_table.temperatures = {300.0, 400.0};
      m.heat_table.conductivities = {2.0, 4.0};
      m.heat_table.specific_heats = {800.0, 800.0};
    }
    deck.walls.push_back(floor_at(overlap));
    const double conductance = 4.0 * std::sqrt(radius * overlap) / (1.0 / 2.0 + 1.0 / 3.0);
    WallHeatDeck& heat = deck.walls[0].heat;
    heat.enabled = true;
    heat.type = by_power ? WallHeatType::power : WallHeatType::ambient;
    heat.power = 50.0 * conductance;
    heat.temperature = 400.0;
    heat.coefficient = conductance;
    WarmScene scene(deck, row(1, 0.0), std::vector<double>{300.0},
                    [](std::vector<ParticlesDeck>& blocks) { blocks[0].isothermal = true; });
    scene.rest(100);  // each step brings it nearer, to the half or so
    EXPECT_NEAR(scene.simulation().heat()->wall_temperatures()[0], 350.0, 1e-9);
  }
}

// Radiation from a wall three times as hot as the grain: its conductance grows so steeply with the wall's temperature
// that a step by the temperature of the step before would swing between 307 and 4930 K.
TEST(Heat, AHotWallThatRadiatesFindsItsTemperature) {
  Deck deck = still_deck(2.0, 800.0, 1e-6);
  deck.heat.every = 1000;
  deck.heat.radiation = true;
  deck.walls.push_back(floor_at(-0.1 * radius));
  WallHeatDeck& heat = deck.walls[0].heat;
  heat.enabled = true;
  const auto isothermal = [](std::vector<ParticlesDeck>& blocks) { blocks[0].isothermal = true; };
  heat.temperature = 900.0;
  WarmScene given(deck, row(1, 0.0), std::vector<double>{300.0}, isothermal);
  given.rest(1);
  const HeatTransfer& transfer = *given.simulation().heat();
  heat.type = WallHeatType::power;
  heat.power = transfer.state().unit().joules(transfer.ledger_here().walls[0].units()) / 1e-3;
  WarmScene found(deck, row(1, 0.0), std::vector<double>{300.0}, isothermal);
  found.rest(200);
  EXPECT_NEAR(found.simulation().heat()->wall_temperatures()[0], 900.0, 1e-3);
}

TEST(Heat, SourcesAndIsothermalBlocks) {
  Deck deck = still_deck(2.0, 800.0, 1e-6);
  deck.heat.every = 1000;
  WarmScene scene(deck, row(2, -2e-6), std::vector<double>{300.0, 300.0}, [](std::vector<ParticlesDeck>& blocks) {
    blocks[0].isothermal = true;
    blocks[1].heating = 500.0;
  });
  scene.rest(60000);
  scene.simulation().check_guards();
  const double mass = sphere_mass(radius, density);
  const double conductance = 4.0 * std::sqrt(0.5 * radius * 2e-6);
  EXPECT_NEAR(scene.temperature(0), 300.0, 1e-12);
  EXPECT_NEAR(scene.temperature(1), 300.0 + 500.0 * mass / conductance, 1e-6);
  const HeatLedger& ledger = scene.simulation().heat()->ledger_here();
  EXPECT_LT((ledger.sources + ledger.kept).units(), ledger.sources.units());
}

TEST(Heat, BoxesOfAPhaseSetTemperaturesAndHeatGrains) {
  Deck deck = still_deck(2.0, 800.0, 1e-6);
  deck.heat.every = 1000;
  const Vec3 low{-1.0, -1.0, -1.0}, high{1.0, 1.0, 1.0};
  deck.phases[0].heat = {{.min = low, .max = high, .temperature = 350.0, .power = 2e-3},
                         {.min = {radius, -1.0, -1.0}, .max = high, .temperature = 400.0},
                         {.min = {5.0 * radius, -1.0, -1.0}, .max = high, .power = -1e-3}};
  PhaseDeck after = deck.phases[0];
  after.name = "after";
  after.heat.clear();
  deck.phases.push_back(after);
  WarmScene scene(deck, row(3, 2.0 * radius), std::vector<double>{300.0, 300.0, 300.0});
  const double capacity = sphere_mass(radius, density) * 800.0;
  const auto expect = [&](double first, double second, double third) {
    EXPECT_NEAR(scene.temperature(0), first, 1e-9);
    EXPECT_NEAR(scene.temperature(1), second, 1e-9);
    EXPECT_NEAR(scene.temperature(2), third, 1e-9);
  };
  const Phase rest(deck.phases[0], scene.simulation());
  expect(350.0, 400.0, 400.0);
  scene.simulation().advance(50000);  // 50 ms
  const double rise = 2e-3 * 0.05 / capacity;
  expect(350.0 + rise, 400.0 + rise, 400.0 - 0.5 * rise);
  const Phase last(deck.phases[1], scene.simulation());
  scene.simulation().advance(50000);
  expect(350.0 + rise, 400.0 + rise, 400.0 - 0.5 * rise);
  const HeatLedger& ledger = scene.simulation().heat()->ledger_here();
  const double joules = scene.simulation().heat()->state().unit().joules(ledger.sources.units());
  EXPECT_NEAR(joules, capacity * (50.0 + 100.0 + 100.0 + 1.5 * rise), 1e-12);
}

TEST(Heat, ATrueStiffnessMakesTheOverlapOfAnIntersectionSmaller) {
  Deck deck = still_deck(2.0, 800.0, 1e-6);
  deck.heat.conductance = ContactConductance::intersection;
  const auto conductance = [&](double overlap) {
    const Conductance of(deck);
    return of.of_pair({radius, 300.0, 0}, {radius, 300.0, 0}, 2.0 * radius - overlap);
  };
  const double narrow = conductance(1e-6);
  for (MaterialDeck& m : deck.materials) m.stiffness_ratio = 1.0 / 64.0;  // (1/64)^(2/3) = 1/16
  EXPECT_NEAR(conductance(16e-6) / narrow, 1.0, 1e-12);
}

TEST(Heat, TwoGrainsApartExchangeByGasAndRadiationAsTheNetworkHasIt) {
  constexpr double k = 2.0, c = 800.0, gap = 20e-6;
  for (const bool radiates : {false, true}) {
    Deck deck = still_deck(k, c, 1e-6);
    deck.heat.every = 1000;
    deck.heat.gas = GapGas::air;
    deck.heat.radiation = radiates;
    WarmScene scene(deck, row(2, gap), std::vector<double>{299.0, 301.0});
    scene.rest(1);
    const double mass = sphere_mass(radius, density);
    const double flow = (301.0 - scene.temperature(1)) * mass * c / 1e-3;  // W
    const GrainPair pair{.radius_1 = radius, .radius_2 = radius, .conductivity_1 = k, .conductivity_2 = k, .gap = gap};
    const Gas gas = air_at(300.0, 101325.0);
    const double h = radiates ? 4.0 * 5.670374419e-8 * 300.0 * 300.0 * 300.0 / (2.0 / 0.8 - 1.0) : 0.0;
    const double expected = gap_conductance(
        pair, {.conductivity = gas.conductivity, .free_path = modified_free_path(gas), .radiation = h}, 0.4);
    EXPECT_NEAR(flow / (2.0 * expected), 1.0, 1e-7);
  }
}

// Rings of columns from the cone in the grain to its surface, and across what is left to the wall (T.17).
TEST(Heat, AGrainNearAWallConductsInColumnsToIt) {
  constexpr double k = 2.0, gap = 0.3 * radius, temperature = 600.0, pressure = 2000.0;
  const double base = 0.560 * radius / std::cbrt(1.0 - 0.4);
  const double height = radius + gap;
  const double rim = radius * base / std::hypot(base, height);
  const Gas air = air_at(temperature, pressure);
  const double h = 4.0 * 5.670374419e-8 * std::pow(temperature, 3) / (2.0 / 0.8 - 1.0);
  for (const auto& [gas, radiates] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    Deck deck = still_deck(k, 800.0, 1e-6);
    deck.heat.gas = gas ? GapGas::air : GapGas::none;
    deck.heat.pressure = pressure;
    deck.heat.radiation = radiates;
    constexpr int rings = 200000;
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
      const double r = rim * (i + 0.5) / rings;
      const double surface = std::sqrt(radius * radius - r * r);
      const double across =
          (gas ? air.conductivity / (height - surface + modified_free_path(air)) : 0.0) + (radiates ? h : 0.0);
      sum += 2.0 * M_PI * r * (rim / rings) / ((surface - r * height / base) / k + 1.0 / across);
    }
    const double found = Conductance(deck).of_wall({radius, temperature, 0}, {0.0, temperature, 0}, height);
    EXPECT_NEAR(found / sum, 1.0, 1e-7) << gas << radiates;
  }
}

/// A column of 40 grains between two walls, whose contacts conduct twice as well as those of the grains: as if the
/// walls were half a spacing away.
class Column {
 public:
  static constexpr std::size_t layers = 40;
  static constexpr double k = 2.0, c = 800.0, overlap = 1e-6;
  static constexpr double spacing = 2.0 * radius - overlap;

  Column() : scene_(deck(), row(layers, -overlap), std::vector<double>(layers, 300.0)) {}

  static double conductance() { return 2.0 * k * std::sqrt(0.5 * radius * overlap); }
  static double capacity() { return sphere_mass(radius, density) * c; }
  static double thermal_step() { return 0.3; }
  WarmScene& scene() { return scene_; }

 private:
  static Deck deck() {
    Deck deck = still_deck(k, c, 1e-6);
    deck.heat.every = 300000;
    const double wall = radius - 2.0 * overlap;
    for (const auto& [x, temperature] : {std::pair(-wall, 500.0), std::pair((layers - 1) * spacing + wall, 300.0)}) {
      WallDeck plane = floor_at(0.0);
      plane.name = temperature > 400.0 ? "hot" : "cold";
      plane.point = {x, 0.0, 0.0};
      plane.normal = {1.0, 0.0, 0.0};
      plane.heat.enabled = true;
      plane.heat.temperature = temperature;
      deck.walls.push_back(plane);
    }
    return deck;
  }

  WarmScene scene_;
};

TEST(Heat, AColumnWarmsUpByTheDiffusionEquation) {
  Column column;
  const double rate = Column::conductance() / Column::capacity();  // diffusivity over the spacing squared, 1/s
  const double length = Column::layers;                            // in spacings
  const double tenth = 0.1 * length * length / rate;               // s
  ASSERT_LT(rate * Column::thermal_step(), 0.2);
  const auto steps = static_cast<std::int64_t>(tenth / Column::thermal_step());
  column.scene().rest(steps);
  const double time = static_cast<double>(steps) * Column::thermal_step();
  double worst = 0.0;
  for (std::size_t i = 0; i < Column::layers; ++i) {
    const double x = (static_cast<double>(i) + 0.5) / length;
    double expected = 1.0 - x;
    for (int n = 1; n < 60; ++n) {
      const double wave = n * pi;
      expected -= 2.0 / wave * std::sin(wave * x) * std::exp(-wave * wave * rate * time / (length * length));
    }
    const double found = (column.scene().temperature(static_cast<std::int64_t>(i)) - 300.0) / 200.0;
    worst = std::max(worst, std::abs(found - expected));
  }
  EXPECT_LT(worst, 0.01);
  std::cout << "  greatest deviation, share of the difference of the walls: " << worst << "\n";
}

TEST(Heat, AColumnAtRestConductsAsItsContactsInARow) {
  Column column;
  const double relaxation = Column::layers * Column::layers / (pi * pi) * Column::capacity() / Column::conductance();
  column.scene().rest(static_cast<std::int64_t>(26.0 * relaxation / Column::thermal_step()));
  const HeatTransfer& heat = *column.scene().simulation().heat();
  const auto given = [&](std::size_t wall) {
    return heat.state().unit().joules(heat.ledger_here().walls[wall].units());
  };
  const double hot = given(0), cold = given(1);
  constexpr std::int64_t steps = 1000;
  column.scene().rest(steps);
  const double expected = 200.0 * Column::conductance() / Column::layers * steps * Column::thermal_step();
  EXPECT_NEAR((given(0) - hot) / expected, 1.0, 1e-9);
  EXPECT_NEAR((cold - given(1)) / expected, 1.0, 1e-9);
}

TEST(Heat, AThermalStepThatIsTooLongIsNamed) {
  Deck deck = still_deck(2000.0, 800.0, 1e-6);
  deck.heat.every = 10000;
  WarmScene scene(deck, row(2, -2e-6), std::vector<double>{300.0, 400.0});
  scene.rest(1);
  try {
    scene.simulation().check_guards();
    FAIL() << "no guard was hit";
  } catch (const PhysicsError& error) {
    EXPECT_NE(std::string(error.what()).find("make heat.every or time.step smaller"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace repose::test
