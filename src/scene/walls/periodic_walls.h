#pragma once

#include <span>

#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// Looks at the walls from both sides of each periodic boundary. DeckError when one is within `reach` m of the boundary
/// on one side, and not as near on the other: a particle that passes there would meet a wall, or lose one, from one
/// step to the next. Samples each boundary, every half `reach` if that is not too often.
void check_walls_meet(const DomainDeck& domain, std::span<const Wall> walls, double reach);

}  // namespace repose
