#pragma once

#include <vector>

#include "deck/deck.h"
#include "integration/time_step.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/materials.h"
#include "scene/walls/wall.h"

namespace repose {

/// What a run of a deck would begin with. DeckError as a run would, also for what would end it later: particles that
/// are poured too fast for the time step.
struct RunPlan {
  RunPlan(const Deck& deck, const ReadFile& read_file);

  MaterialTable materials;
  std::vector<Wall> walls;
  Insertion insertion;
  TimeStep dt;
};

/// Particle-steps a second and core for estimates: roughly what the quick and the mini discharge took on one core of
/// 2021.
constexpr double usual_core_speed = 8e6;

/// Steps of a run whose every phase takes its longest.
double most_steps(const Deck& deck, const TimeStep& dt);

}  // namespace repose
