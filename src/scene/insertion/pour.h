#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/insertion/insertion_face.h"

namespace repose {

/// What a pour block will bring in: planned at the start, a function of the deck alone. Its particles are numbered from
/// first_id on and enter in this order.
struct Pour {
  std::string block;  ///< for messages
  ParticlesDeck deck;
  std::optional<InsertionFace> face;  ///< region = face
  Box bounds;                         ///< of the region
  std::int64_t first_id = 0;
  int material = 0;
  std::vector<double> radius;    ///< m
  std::vector<double> due_time;  ///< s, when the particle is to enter; increasing
  double interval = 0.0;         ///< s, between batches

  std::int64_t size() const { return static_cast<std::int64_t>(radius.size()); }
};

/// Plans a pour of particles of these radii (m) and of a density (kg/m^3) under gravity (m/s^2): each is due when its
/// mass, or its number, has come at the rate. The interval is given, or the time in which a particle falls through the
/// region and by the largest diameter; `walls` are those of the deck. DeckError when nothing carries the particles out
/// of the region, or the region is outside the domain or too small for one.
Pour plan_pour(const Deck& deck, std::size_t block, const std::string& name, const std::vector<Wall>& walls,
               std::vector<double> radius, double density);

/// A random place for a sphere in the region of a pour (region.h).
std::optional<Vec3> random_place(const Pour& pour, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k);

}  // namespace repose
