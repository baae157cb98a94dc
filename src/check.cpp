#include "check.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "integration/time_step.h"
#include "output/progress.h"
#include "phases.h"
#include "scene/sphere.h"
#include "setup.h"

namespace repose {
namespace {

// Rough figures for the estimates: what the quick and the mini discharge took on one core of 2021.
constexpr double bytes_per_particle = 1000.0;
constexpr double bytes_per_rank = 60e6;  // the program and its libraries
constexpr double particle_steps_per_second_and_rank = 8e6;

}  // namespace

std::string check_report(const Deck& deck, const ReadFile& read_file, int ranks) {
  const MaterialTable materials(deck);
  const std::vector<Wall> walls = make_walls(deck, materials, read_file);
  const NewParticles particles = insert_particles(deck, walls, read_file);
  const TimeStep dt =
      choose_time_step(deck, materials, smallest_radii(particles, materials.size()), expected_speed(deck, particles));
  const double count = static_cast<double>(particles.size());
  double mass = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    mass += sphere_mass(particles.radius[i], materials[static_cast<std::size_t>(particles.material[i])].density);
  }

  std::string report = fmt::format("particles   {} ({:.6g} kg)\n", particles.size(), mass);
  for (const Wall& wall : walls) {
    if (const auto* mesh = std::get_if<Mesh>(&wall.shape)) {
      report += fmt::format("mesh        {}: {}\n", wall.name, describe(*mesh));
    }
  }
  report += fmt::format("time step   {:.6g} s, {}\n", dt.step,
                        dt.criterion == "given" ? "given in the deck" : "set by the " + dt.criterion + " criterion");
  report += fmt::format("limits      {:.4g} s Rayleigh ({:.0f} %), {:.4g} s Hertz ({:.0f} %, at {:.3g} m/s)\n",
                        dt.rayleigh_limit, 100.0 * deck.time.rayleigh_fraction, dt.hertz_limit,
                        100.0 * deck.time.hertz_fraction, dt.speed);
  double steps = 0.0;
  for (const PhaseDeck& phase : deck.phases) {
    const auto longest = static_cast<double>(longest_steps(phase, dt.step));
    const bool open_end = phase.until == PhaseUntil::kinetic_energy;
    report += fmt::format("phase       {}: {}{:.0f} steps ({:.4g} s)\n", phase.name, open_end ? "at most " : "",
                          longest, longest * dt.step);
    steps += longest;
  }
  report += fmt::format("steps       {:.0f}\n", steps);
  report += fmt::format("memory      about {:.0f} MB\n", 1e-6 * (count * bytes_per_particle + ranks * bytes_per_rank));
  report += fmt::format("wall time   about {} on {} rank{}, if every phase takes its longest\n",
                        duration_text(count * steps / (particle_steps_per_second_and_rank * ranks)), ranks,
                        ranks == 1 ? "" : "s");
  return report;
}

}  // namespace repose
