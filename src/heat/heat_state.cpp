#include "heat/heat_state.h"

#include <algorithm>
#include <cmath>

#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

double greatest_heat(const Conductance& conductance, const MaterialTable& materials, const Insertion& insertion) {
  double greatest = 0.0;
  insertion.for_each([&](double radius, std::size_t material) {
    const auto solid = static_cast<std::size_t>(materials.solid(static_cast<std::int32_t>(material)));
    const double heat =
        sphere_mass(radius, materials[material].density) * conductance.table(solid).energy(greatest_temperature);
    greatest = std::max(greatest, heat);
  });
  return greatest;
}

}  // namespace

HeatState::HeatState(const Deck& deck, const MaterialTable& materials, const Insertion& insertion, double growth)
    : materials_(materials),
      conductance_(deck),
      temperature_of_rest_(deck.heat.temperature),
      unit_(growth * greatest_heat(conductance_, materials, insertion)) {
  for (std::size_t k = 0; k < deck.particles.size(); ++k) {
    const ParticlesDeck& block = deck.particles[k];
    blocks_.push_back({insertion.block_begin[k + 1], block.temperature, block.isothermal, block.heating});
    has_special_blocks_ = has_special_blocks_ || block.isothermal || block.heating != 0.0;
  }
}

const HeatState::Block& HeatState::block_of(std::int64_t id) const {
  return *std::upper_bound(blocks_.begin(), blocks_.end(), id,
                           [](std::int64_t number, const Block& block) { return number < block.end; });
}

double HeatState::mass(double radius, std::int32_t material) const {
  return sphere_mass(radius, materials_[static_cast<std::size_t>(material)].density);
}

std::int64_t HeatState::entering(std::int64_t id, double radius, std::int32_t material, double in_file) const {
  const double of_block = block_of(id).temperature;
  const double temperature = !std::isnan(of_block) ? of_block : !std::isnan(in_file) ? in_file : temperature_of_rest_;
  return heat_at(temperature, radius, material);
}

std::int64_t HeatState::heat_at(double temperature, double radius, std::int32_t material) const {
  const double energy = conductance_.table(solid(material)).energy(temperature);
  return std::llrint(mass(radius, material) * energy * unit_.per_joule());
}

double HeatState::temperature(const Particles& particles, std::size_t i) const {
  const std::int32_t material = particles.material[i];
  const double joules = unit_.joules(static_cast<double>(particles.heat[i]));
  return conductance_.table(solid(material)).temperature(joules / mass(particles.record[i].radius, material));
}

double HeatState::capacity(const Particles& particles, std::size_t i, double temperature) const {
  const std::int32_t material = particles.material[i];
  return mass(particles.record[i].radius, material) * conductance_.table(solid(material)).specific_heat(temperature);
}

double HeatState::heating(const Particles& particles, std::size_t i) const {
  if (!has_special_blocks_) return 0.0;
  const double per_mass = block_of(particles.id[i]).heating;
  return per_mass == 0.0 ? 0.0 : per_mass * mass(particles.record[i].radius, particles.material[i]);
}

}  // namespace repose
