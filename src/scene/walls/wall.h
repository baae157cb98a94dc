#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "files/read_file.h"
#include "scene/walls/motion.h"
#include "scene/walls/servo.h"
#include "scene/walls/wall_shape.h"

namespace repose {

/// A named surface with a material.
struct Wall {
  std::string name;
  int material = 0;     ///< index into the deck's materials
  bool present = true;  ///< false until a phase adds it
  WallShape shape;
  Motions motions;                        ///< what moves it by prescription
  std::optional<Servo> servo;             ///< what moves it by the force of the grains
  std::optional<std::size_t> moves_with;  ///< place among all walls of the one whose motions and servo move this one
  bool travels = false;     ///< false: its motions leave its shape where it is, as a drum's about its own axis do
  double inner_skin = 0.0;  ///< m, how far it may travel while an inner list is good
  double outer_skin = 0.0;  ///< m, the same of an outer list
  Placement placement;      ///< where its motions have brought it; as in the deck when it does not travel

  bool moves() const { return !motions.empty() || servo || moves_with; }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("present", self.present);
    v("motions", self.motions);
    if (self.servo) v("servo", *self.servo);
  }
};

/// A wall from its deck section; a disc becomes a profile of one segment. A mesh's file is read by `read_file`.
/// DeckError, naming the wall, when its shape makes no sense.
Wall make_wall(const WallDeck& deck, int material, const ReadFile& read_file = {});

/// From now on walls[follower] moves with walls[leader], which moves by itself, as one rigid body.
void join(std::vector<Wall>& walls, std::size_t follower, std::size_t leader);

/// The places of a wall that moves by itself, and of those that move with it.
std::vector<std::size_t> body_of(std::span<const Wall> walls, std::size_t leader);

/// Brings a wall that moves by itself to where its motions and its servo are after all steps so far of `dt` s.
void place(Wall& wall, double dt);
/// The same of all walls that move, by themselves or with others.
void place(std::span<Wall> walls, double dt);

/// Appends to `out` all features of the wall whose distance from `centre` is less than `reach` (m), tagged with the
/// index `wall_index`; returns how many. Does not ask whether the wall is present.
int find_touches(const Wall& wall, int wall_index, const Vec3& centre, double reach, TouchBuffer& out);

/// How far in m the surface may be from where the deck means it to be, as the file of a mesh has single precision.
inline double flatness(const Wall& wall) {
  const auto* mesh = std::get_if<Mesh>(&wall.shape);
  return mesh == nullptr ? 0.0 : flatness(*mesh);
}

/// Distance in m from `centre` to the surface.
double distance(const Wall& wall, const Vec3& centre);

/// Whether the surface is nearer to `centre` than `reach` (m); it may also be true when it is farther by rounding.
bool is_within(const Wall& wall, const Vec3& centre, double reach);

/// The face that feature `feature` is, as in the deck.
Face face_of(const Wall& wall, int feature);

/// Whether a particle whose only touch within `reach` (m, its radius and skin) is the face `feature` can touch nothing
/// else of the wall until it has moved by `skin` (m).
bool keeps_to_face(const Wall& wall, int feature, const Vec3& centre, double reach, double skin);

/// Whether two features of a wall meet (or are one), so that a contact may pass from one to the other with its history.
bool adjacent_features(const Wall& wall, int a, int b);

}  // namespace repose
