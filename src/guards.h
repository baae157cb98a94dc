#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "contact/wall_contacts.h"
#include "neighbours/pair_lists.h"
#include "scene/particles.h"
#include "scene/wall.h"

namespace repose {

/// One line on the contact that hit a guard: what, which particles, where, at which step, and what would help. Searches
/// all contacts of this rank; called only when an evaluation has raised an alarm.
std::string describe_alarm(const Particles& particles, const PairLists& pairs, const WallContacts& wall_contacts,
                           std::span<const Wall> walls, double max_overlap, std::int64_t step);

}  // namespace repose
