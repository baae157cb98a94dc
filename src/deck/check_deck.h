#pragma once

#include "deck/deck.h"
#include "deck/deck_errors.h"

namespace repose {

/// Notes what is wrong between the keys of a deck whose single keys are right: names used twice or unknown, missing
/// pairs, impossible shapes, phases that add or remove walls out of order.
void check_deck(const Deck& deck, DeckErrors& errors);

/// The shapes of the walls only (a part of check_deck).
void check_wall_shapes(const Deck& deck, DeckErrors& errors);

/// What the contact law needs of the pairs (a part of check_deck).
void check_contact(const Deck& deck, DeckErrors& errors);

/// Conditions of the phases, whether they can come to hold, and the order in which walls are added and removed (a part
/// of check_deck).
void check_phases(const Deck& deck, DeckErrors& errors);

/// Axes and phases of motions, and which particles have them (a part of check_deck).
void check_motions(const Deck& deck, DeckErrors& errors);

/// That walls which move are there in some phase (a part of check_deck).
void check_moving_walls(const Deck& deck, DeckErrors& errors);

/// Axes, limits and phases of walls under load, and walls that move with others (a part of check_deck).
void check_servos(const Deck& deck, DeckErrors& errors);

/// Axis, rate and phases of the tilt, and what the measurements of slopes need (a part of check_deck).
void check_tilt(const Deck& deck, DeckErrors& errors);

/// That the shares of the time step are those of the contact law (a part of check_deck).
void check_time(const Deck& deck, DeckErrors& errors);

/// What the measurements of grains that lie or fall need: heights, gravity, boxes (a part of check_deck).
void check_grain_measurements(const Deck& deck, DeckErrors& errors);

/// What the measurements on walls that move need: walls, phases, directions (a part of check_deck).
void check_driven_measurements(const Deck& deck, DeckErrors& errors);

/// That a height lies in the domain (a part of check_deck).
void check_height(const std::string& section, const char* key, double height, const DomainDeck& domain,
                  DeckErrors& errors);

/// That phases that are named are there; whether they are (a part of check_deck).
bool check_phase_names(const std::string& section, const std::vector<std::string>& named, const Deck& deck,
                       DeckErrors& errors);

/// That the phases in which something acts, such as "the motion", are there, each named once, and that grains move in
/// one of them (a part of check_deck).
void check_acting_phases(const std::string& section, const char* what, const std::vector<std::string>& named,
                         const Deck& deck, DeckErrors& errors);

/// That an axis of torques has a direction, and that of every periodic boundary (a part of check_deck).
void check_torque_axis(const std::string& section, const Vec3& direction, const Deck& deck, DeckErrors& errors);

/// That a direction of a section has a length (a part of check_deck).
void check_direction(const std::string& section, const char* key, const Vec3& direction, DeckErrors& errors);

/// The wall of this name; null, and a note at `key`, when there is none (a part of check_deck).
const WallDeck* find_wall(const std::string& key, const std::string& name, const Deck& deck, DeckErrors& errors);

/// The walls of these names, null where there is none; notes those, and at `key` that it names none but should name
/// those of `whom` (a part of check_deck).
std::vector<const WallDeck*> find_walls(const std::string& key, const std::vector<std::string>& names,
                                        const std::string& whom, const Deck& deck, DeckErrors& errors);

/// That factors over time have a time each, and these rise (a part of check_deck).
void check_course(const std::string& section, const std::vector<double>& times, const std::vector<double>& factors,
                  DeckErrors& errors);

/// The blocks of particles: amounts, regions, sizes (a part of check_deck).
void check_particles(const Deck& deck, DeckErrors& errors);

/// That a box [min, max] of a section has a volume (a part of check_deck).
void check_box(const std::string& section, const Vec3& min, const Vec3& max, DeckErrors& errors);

/// What [heat] needs of materials, walls and blocks, and what needs [heat] (a part of check_deck).
void check_heat(const Deck& deck, DeckErrors& errors);

/// Periodic directions and named exits (a part of check_deck).
void check_domain(const Deck& deck, DeckErrors& errors);

}  // namespace repose
