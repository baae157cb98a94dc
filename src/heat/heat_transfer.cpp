#include "heat/heat_transfer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/interpolate.h"
#include "comm/order_independent_sum.h"

namespace repose {
namespace {

double factor_at(const WallHeatDeck& wall, double time) {
  return wall.times.empty() ? 1.0 : interpolate(wall.times, wall.factors, time);
}

constexpr int share_bits = 48;
constexpr double undetermined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

HeatTransfer::HeatTransfer(const Deck& deck, const MaterialTable& materials, const Insertion& insertion, double growth)
    : state_(deck, materials, insertion, growth),
      every_(deck.heat.every),
      ledger_(HeatLedger::none(deck.walls.size())) {
  for (const WallDeck& wall : deck.walls) walls_.push_back(wall.heat);
  wall_temperature_.assign(walls_.size(), undetermined);
  conducting_temperature_ = wall_temperature_;
  set_given_wall_temperatures(0.0);
}

void HeatTransfer::enter(double temperature, Particles& particles) {
  const std::size_t i = particles.heat.size();
  particles.heat.push_back(
      state_.entering(particles.id[i], particles.record[i].radius, particles.material[i], temperature));
  ledger_.brought.add(particles.heat[i]);
}

void HeatTransfer::multiply(double mass_factor, std::size_t i, Particles& particles) {
  const std::int64_t grown = std::llrint(static_cast<double>(particles.heat[i]) * mass_factor);
  ledger_.brought.add(grown - particles.heat[i]);
  particles.heat[i] = grown;
}

void HeatTransfer::warm(Particles& particles) {
  if (boxes_.is_empty()) return;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const double temperature = boxes_.temperature(particles.position(i));
    if (std::isnan(temperature) || is_parked(particles.record[i])) continue;
    const std::int64_t warm = state_.heat_at(temperature, particles.record[i].radius, particles.material[i]);
    ledger_.sources.add(warm - particles.heat[i]);
    particles.heat[i] = warm;
  }
}

void HeatTransfer::take_leavers(Particles& particles) {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (!is_parked(particles.record[i]) || particles.heat[i] == 0) continue;
    ledger_.left.add(particles.heat[i]);
    particles.heat[i] = 0;
  }
}

std::optional<HeatFault> HeatTransfer::advance(const HeatScene& scene, Particles& particles) {
  fault_.reset();
  gain_.assign(particles.owned, 0);
  levelled_.assign(particles.owned, 0);
  set_temperatures(scene, particles);
  exchange_pairs(scene, particles);
  set_given_wall_temperatures(scene.time);
  const std::vector<WallFlow> flows = wall_flows(scene, particles);
  set_other_wall_temperatures(scene, flows);
  exchange_walls(scene, flows);
  add_sources(scene, particles);
  settle(scene, particles);
  return fault_;
}

void HeatTransfer::set_temperatures(const HeatScene& scene, const Particles& particles) {
  temperature_.resize(particles.total());
  capacity_.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    temperature_[i] = state_.temperature(particles, i);
    capacity_[i] = state_.capacity(particles, i, temperature_[i]);
  }
  scene.ghosts.share(particles.owned, temperature_);
}

WarmBody HeatTransfer::body(const Particles& particles, std::size_t i) const {
  return {particles.record[i].radius, temperature_[i], state_.solid(particles.material[i])};
}

/// Units for joules that reach a particle.
std::int64_t HeatTransfer::flow(double joules, std::size_t particle) {
  const double units = joules * state_.unit().per_joule();
  if (std::fabs(units) < greatest_flow) return std::llrint(units);
  note_fault(particle, "more heat flows into it in a thermal step than it can hold");
  return 0;
}

void HeatTransfer::note_fault(std::size_t particle, const std::string& what) {
  if (!fault_) fault_ = HeatFault{particle, what};
}

/// Added as integers: the guard must not depend on their order either.
void HeatTransfer::note_conductance(std::size_t particle, double conductance, double step) {
  constexpr double most = 16.0;  // as bad as any; 2000 of them fit
  levelled_[particle] += std::llrint(std::ldexp(std::min(conductance * step / capacity_[particle], most), share_bits));
}

void HeatTransfer::exchange_pairs(const HeatScene& scene, const Particles& particles) {
  const bool contacts_alone = state_.conductance().reach_share() == 0.0;
  for (const PairGroup& group : scene.pairs.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) {
      if (contacts_alone && pair.lane < 0) continue;  // not even near
      const auto i = static_cast<std::size_t>(pair.first);
      const auto j = static_cast<std::size_t>(pair.second);
      const double distance = norm(particles.record[i].position - particles.record[j].position);
      const double conductance = state_.conductance().of_pair(body(particles, i), body(particles, j), distance);
      if (conductance == 0.0) continue;
      const double joules = conductance * (temperature_[j] - temperature_[i]) * scene.step;
      const std::int64_t units = flow(joules, i < particles.owned ? i : j);
      if (i < particles.owned) {
        gain_[i] += units;
        note_conductance(i, conductance, scene.step);
      }
      if (j < particles.owned) {
        gain_[j] -= units;
        note_conductance(j, conductance, scene.step);
      }
    }
  }
}

std::vector<HeatTransfer::WallFlow> HeatTransfer::wall_flows(const HeatScene& scene, const Particles& particles) {
  std::vector<WallFlow> flows;
  const double share = state_.conductance().reach_share();
  const bool all_seen =
      scene.wall_contacts.for_each_near(scene.walls, particles, share, [&](std::size_t i, const WallTouch& touch) {
        const auto w = static_cast<std::size_t>(touch.wall);
        if (!walls_[w].enabled) return;
        const WarmBody grain = body(particles, i);
        const bool is_known = conducting_temperature_[w] > 0.0;  // neither NaN nor what a power below 0 may come to
        const double temperature = is_known ? conducting_temperature_[w] : grain.temperature;
        const WarmBody wall{0.0, temperature, static_cast<std::size_t>(scene.walls[w].material)};
        const double conductance = state_.conductance().of_wall(grain, wall, touch.distance);
        if (conductance == 0.0) return;
        flows.push_back({static_cast<std::int32_t>(i), touch.wall, conductance});
        note_conductance(i, conductance, scene.step);
      });
  if (!all_seen)
    note_fault(0, "more parts of walls are near a particle than can be told apart; heat.max_gap is too wide");
  return flows;
}

void HeatTransfer::set_given_wall_temperatures(double time) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (!walls_[w].enabled || walls_[w].type != WallHeatType::temperature) continue;
    conducting_temperature_[w] = wall_temperature_[w] = walls_[w].temperature * factor_at(walls_[w], time);
  }
}

/// Those of walls without heat capacity follow from the balance: power + coefficient (outside - wall) = sum of
/// conductance (wall - grain).
void HeatTransfer::set_other_wall_temperatures(const HeatScene& scene, std::span<const WallFlow> flows) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const WallHeatDeck& wall = walls_[w];
    if (!wall.enabled || wall.type == WallHeatType::temperature) continue;
    const double factor = factor_at(wall, scene.time);
    std::vector<double> conductance, weighted;
    for (const WallFlow& f : flows) {
      if (static_cast<std::size_t>(f.wall) != w) continue;
      conductance.push_back(f.conductance);
      weighted.push_back(f.conductance * temperature_[static_cast<std::size_t>(f.particle)]);
    }
    const double sum = order_independent_sum(scene.comm, conductance);
    const double heat = order_independent_sum(scene.comm, weighted);
    const bool is_power = wall.type == WallHeatType::power;
    const double outside = is_power ? 0.0 : wall.coefficient;
    const double given = is_power ? wall.power * factor : outside * wall.temperature * factor;
    wall_temperature_[w] = sum > 0.0 ? (given + heat) / (outside + sum) : undetermined;
    // Half way: radiation grows with the third power, and a step that went all the way would swing to and fro.
    const double before = conducting_temperature_[w] > 0.0 ? conducting_temperature_[w] : wall_temperature_[w];
    conducting_temperature_[w] = 0.5 * (before + wall_temperature_[w]);
  }
}

void HeatTransfer::exchange_walls(const HeatScene& scene, std::span<const WallFlow> flows) {
  for (const WallFlow& f : flows) {
    const auto i = static_cast<std::size_t>(f.particle);
    const auto w = static_cast<std::size_t>(f.wall);
    const std::int64_t units = flow(f.conductance * (wall_temperature_[w] - temperature_[i]) * scene.step, i);
    gain_[i] += units;
    ledger_.walls[w].add(units);
  }
}

void HeatTransfer::add_sources(const HeatScene& scene, const Particles& particles) {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const double power = state_.heating(particles, i) + (boxes_.is_empty() ? 0.0 : boxes_.power(particles.position(i)));
    if (power == 0.0 || is_parked(particles.record[i])) continue;
    const std::int64_t units = flow(power * scene.step, i);
    gain_[i] += units;
    ledger_.sources.add(units);
  }
}

/// An explicit step is stable as long as no particle takes in more than would level it with its surroundings.
void HeatTransfer::settle(const HeatScene& scene, Particles& particles) {
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) continue;
    if (state_.is_isothermal(particles.id[i])) {
      ledger_.kept.add(-gain_[i]);
      continue;
    }
    particles.heat[i] += gain_[i];
    const double share = std::ldexp(static_cast<double>(levelled_[i]), -share_bits);
    if (share > 1.0) {
      note_fault(i, fmt::format("heat levels it {:.3g} times within one thermal step of {:.3g} s; make heat.every or "
                                "time.step smaller by as much",
                                share, scene.step));
    }
    const double now = state_.temperature(particles, i);
    if (!(now > 0.0) || now > greatest_temperature) {
      note_fault(i, fmt::format("its temperature is {:.4g} K, beyond 0 to {:.0f} K", now, greatest_temperature));
    }
  }
}

}  // namespace repose
