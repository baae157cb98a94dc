#pragma once

#include "fields/coarse_grain.h"
#include "fields/state.h"

namespace repose::fields {

/// The forces at all contacts of a state by the contact law of its deck, at the velocities of the full step (the time
/// loop takes half-step ones: the dashpots differ by that). Where the contacts remember (checkpoint) they are whole;
/// else normal forces alone (spring, dashpot and cohesion): friction needs its history. Surfaces that adhesion holds
/// together across a gap are found where they remember alone. FileError, beginning with `file`, when a force is out of
/// the range that a run allows.
ContactForces find_contacts(const State& state, const std::string& file);

}  // namespace repose::fields
