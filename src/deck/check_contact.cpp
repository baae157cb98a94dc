#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

/// Without attraction the dashpot grows as 1 / sqrt(restitution), and with it the step that an impact needs.
constexpr double least_restitution_without_attraction = 0.05;

void check_stiffness(const std::string& section, const PairDeck& pair, const ContactDeck& contact, DeckErrors& errors) {
  const bool is_hooke = contact.normal_law == NormalLaw::hooke;
  const bool by_velocity = contact.hooke_characteristic_velocity > 0.0;
  const bool is_given = !std::isnan(pair.hooke_stiffness);
  if (is_hooke && !by_velocity && !is_given) {
    errors.add(section, "[[pair]] lacks \"hooke_stiffness\", which contact.normal_law = \"hooke\" needs");
  }
  if (is_hooke && by_velocity && is_given) {
    errors.add(
        section + ".hooke_stiffness",
        "\"hooke_stiffness\" and contact.hooke_characteristic_velocity both say how stiff the pair is; remove one");
  }
  if (!is_hooke && is_given) {
    errors.add(section + ".hooke_stiffness",
               "\"hooke_stiffness\" belongs to contact.normal_law = \"hooke\"; set that, or remove this");
  }
  if (!is_hooke && pair.hooke_tangential_ratio != PairDeck{}.hooke_tangential_ratio) {
    errors.add(section + ".hooke_tangential_ratio",
               "\"hooke_tangential_ratio\" belongs to contact.normal_law = \"hooke\"; set that, or remove this");
  }
  if (!is_hooke && has_hooke_damping_rate(pair)) {
    errors.add(section + ".hooke_damping_rate",
               "\"hooke_damping_rate\" belongs to contact.normal_law = \"hooke\"; set that, or give \"restitution\"");
  }
}

void check_damping_rates(const std::string& section, const PairDeck& pair, const ContactDeck& contact,
                         DeckErrors& errors) {
  if (!has_hooke_damping_rate(pair)) return;
  const std::string key = section + ".hooke_tangential_damping_rate";
  if (contact.tangential_damping == TangentialDamping::normal) {
    errors.add(key,
               "\"hooke_tangential_damping_rate\" and contact.tangential_damping = \"normal\" both say how the pair is "
               "damped; remove the latter");
  }
  if (contact.tangential_damping == TangentialDamping::none && pair.hooke_tangential_damping_rate != 0.0) {
    errors.add(key, fmt::format("\"hooke_tangential_damping_rate\" = {} contradicts contact.tangential_damping = "
                                "\"none\"; give 0, or remove the latter",
                                pair.hooke_tangential_damping_rate));
  }
}

/// A coefficient that no part of the law would read is an oversight.
void check_used(const std::string& section, const char* key, double value, bool is_used, const char* owner,
                DeckErrors& errors) {
  if (value == 0.0 || is_used) return;
  errors.add(fmt::format("{}.{}", section, key),
             fmt::format("\"{}\" belongs to contact.{}; set that, or remove this", key, owner));
}

void check_combinations(const ContactDeck& contact, DeckErrors& errors) {
  if (contact.normal_law == NormalLaw::jkr && !contact.attraction) {
    errors.add("contact.attraction", "\"attraction\" = false contradicts contact.normal_law = \"jkr\"; remove it");
  }
  if (contact.cohesion != Cohesion::none && contact.normal_law == NormalLaw::jkr) {
    errors.add("contact.cohesion", "contact.normal_law = \"jkr\" has adhesion of its own; set cohesion = \"none\"");
  }
  if (contact.cohesion_in_friction && contact.cohesion == Cohesion::none) {
    errors.add("contact.cohesion_in_friction",
               "\"cohesion_in_friction\" needs contact.cohesion; set that, or remove this");
  }
  if (contact.rolling_history == RollingHistory::rotated && contact.rolling_model == RollingModel::cdt) {
    errors.add(
        "contact.rolling_history",
        "\"rolling_history\" = \"rotated\": contact.rolling_model = \"cdt\" has no history; remove one of the two");
  }
}

}  // namespace

void check_contact(const Deck& deck, DeckErrors& errors) {
  check_combinations(deck.contact, errors);
  for (std::size_t i = 0; i < deck.pairs.size(); ++i) {
    const std::string section = fmt::format("pair.{}", i);
    const PairDeck& pair = deck.pairs[i];
    check_stiffness(section, pair, deck.contact, errors);
    check_damping_rates(section, pair, deck.contact, errors);
    check_used(section, "work_of_adhesion", pair.work_of_adhesion, deck.contact.normal_law == NormalLaw::jkr,
               "normal_law = \"jkr\"", errors);
    const Cohesion cohesion = deck.contact.cohesion;
    check_used(section, "cohesion_energy_density", pair.cohesion_energy_density,
               cohesion == Cohesion::sjkr || cohesion == Cohesion::sjkr2, "cohesion = \"sjkr\" or \"sjkr2\"", errors);
    const bool has_bridges = cohesion == Cohesion::capillary;
    check_used(section, "surface_tension", pair.surface_tension, has_bridges, "cohesion = \"capillary\"", errors);
    check_used(section, "contact_angle", pair.contact_angle, has_bridges, "cohesion = \"capillary\"", errors);
    check_used(section, "bridge_volume", pair.bridge_volume, has_bridges, "cohesion = \"capillary\"", errors);
    if (pair.bridge_volume > 0.0 && pair.bridge_volume < 1e-30) {
      errors.add(section + ".bridge_volume", "\"bridge_volume\" is less than 1e-30 m3; give 0 for no bridge");
    }
    check_used(section, "rolling_viscous_damping", pair.rolling_viscous_damping,
               deck.contact.rolling_model == RollingModel::epsd, "rolling_model = \"epsd\"", errors);
    if (!deck.contact.attraction && deck.contact.restitution_correction &&
        pair.restitution < least_restitution_without_attraction) {
      errors.add(section + ".restitution",
                 fmt::format("\"restitution\" = {} is less than {}, the least with contact.attraction = false",
                             pair.restitution, least_restitution_without_attraction));
    }
  }
}

}  // namespace repose
