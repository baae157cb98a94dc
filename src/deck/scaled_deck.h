#pragma once

#include <map>
#include <string>

namespace repose {

/// What a deck is made anew for. The ratios are new over old.
struct DeckScale {
  double grains = 1.0;                  ///< of the diameters of grains, and of what is as large as they are
  double lengths = 1.0;                 ///< of all other lengths
  double density = 1.0;                 ///< of grains
  std::map<std::string, double> given;  ///< numbers in SI by key, such as "pair.0.restitution", that replace the deck's
};

/// The text of a deck for other grains or another size, comments included: the same test under the same gravity. By the
/// unit of its key a number goes with the lengths L, with times as the root of L (Froude's law) and with masses as
/// density x L^3, so that speeds go as the root of L, and Young's moduli as density x L: a bed gives way by the same
/// share. Diameters, spacings and energies of grains go with the size of grains; counts with the number of grains that
/// then fill the same part of the apparatus. Densities, coefficients and gravity stay, but for what is `given`, whose
/// comment at the end of the line goes with the old value. Numbers keep their unit and get six digits. `path` names the
/// text in a DeckError: its syntax is wrong, or the deck has no such key as one that is given.
std::string scaled_deck(const std::string& text, const std::string& path, const DeckScale& scale);

}  // namespace repose
