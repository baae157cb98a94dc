#pragma once

#include <vector>

#include "base/vec3.h"
#include "deck/contact_keys.h"
#include "deck/domain_keys.h"
#include "deck/heat_keys.h"
#include "deck/measurement_keys.h"
#include "deck/particle_keys.h"
#include "deck/phase_keys.h"
#include "deck/run_keys.h"
#include "deck/wall_keys.h"

/// The deck as plain structs, SI units throughout. The *_keys.h hold the sections, and with each section the name,
/// unit, range, default and meaning of its keys, once; read_deck fills them and has checked everything that can be
/// checked without the scene.
namespace repose {

struct Deck : MeasurementDecks {
  RunDeck run;
  Vec3 gravity{0.0, 0.0, -9.81};
  DomainDeck domain;
  std::vector<ExitDeck> exits;          ///< [[exit]]
  std::vector<MaterialDeck> materials;  ///< [[material]]
  std::vector<PairDeck> pairs;          ///< [[pair]]
  ContactDeck contact;
  std::vector<WallDeck> walls;           ///< [[wall]]
  std::vector<ParticlesDeck> particles;  ///< [[particles]]
  HeatDeck heat;
  TiltDeck tilt;
  TimeDeck time;
  std::vector<PhaseDeck> phases;  ///< [[phase]]
  OutputDeck output;
  GuardsDeck guards;
  NeighboursDeck neighbours;
};

/// Keys come in the order in which conditions need them: a type before what depends on it.
template <class V>
void describe(V& v, Deck& d) {
  v("gravity", d.gravity, Unit::acceleration, any_value, optional, "gravitational acceleration");
  v.section("run", d.run, optional, "the run as a whole");
  v.section("domain", d.domain, required, "the box that is simulated; a particle that leaves it is counted and gone");
  v.sections("exit", d.exits, optional,
             "a part of a face of the domain; what leaves through it is counted by its name");
  v.sections("material", d.materials, required, "a solid");
  v.sections("pair", d.pairs, required, "contact of two materials, in either order");
  v.section("contact", d.contact, optional, "the contact law; the defaults are that of the thesis");
  v.sections("wall", d.walls, optional, "a rigid surface, felt from both sides");
  v.sections("particles", d.particles, required, "a block of spheres");
  v.section("heat", d.heat, optional, "the particles have temperatures and exchange heat");
  v.section("tilt", d.tilt, optional, "tilts the apparatus: gravity turns the other way");
  v.section("time", d.time, optional, "the time step");
  v.sections("phase", d.phases, required, "a stage of the run; the phases follow each other");
  v.group("measurement", [&d](V& g) { describe_measurements(g, d); });
  v.section("output", d.output, optional, "what is written and when");
  v.section("guards", d.guards, optional, "bounds that stop the run when the physics breaks");
  v.section("neighbours", d.neighbours, optional, "search and balance; they change the speed, never the result");
}

}  // namespace repose
