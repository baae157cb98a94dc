#pragma once

#include "deck/schema_measurement.h"
#include "deck/schema_particles.h"
#include "deck/schema_run.h"
#include "deck/schema_scene.h"

/// The schema: every key of a deck with its unit, range, default and meaning, once. The reader, the writer and
/// `repose keys` are visitors of it. Keys come in the order in which conditions need them: a type before what depends
/// on it.
namespace repose {

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
  v.section("tilt", d.tilt, optional, "tilts the apparatus: gravity turns the other way");
  v.section("time", d.time, optional, "the time step");
  v.sections("phase", d.phases, required, "a stage of the run; the phases follow each other");
  v.group("measurement", [&d](V& g) {
    g.section("discharge", d.discharge, optional, "measure the mass that leaves an orifice");
    g.section("angle_of_repose", d.angle_of_repose, optional, "measure the slope of the pile from its side view");
    g.section("scattering", d.scattering, optional, "count the grains that lie around the pile, seen from above");
    g.section("tilt_onset", d.tilt_onset, optional, "measure the tilt at which a particle begins to move");
    g.section("surface_angle", d.surface_angle, optional, "measure the slope of the bed in a rotating drum");
  });
  v.section("output", d.output, optional, "what is written and when");
  v.section("guards", d.guards, optional, "bounds that stop the run when the physics breaks");
  v.section("neighbours", d.neighbours, optional, "search and balance; they change the speed, never the result");
}

}  // namespace repose
