#pragma once

#include <vector>

#include "deck/deck.h"

namespace repose::test {

/// `deck` with Hooke's law; its stiffness is that of Hertz at an overlap of a few per cent of 0.5 mm.
inline Deck with_hooke(Deck deck) {
  deck.contact.normal_law = NormalLaw::hooke;
  for (PairDeck& pair : deck.pairs) pair.hooke_stiffness = 400.0;
  deck.time.hooke_fraction = 0.1;
  return deck;
}

/// `deck` with every combination of the options of [contact] and time.integrator; the first has the defaults.
inline std::vector<Deck> decks_of_all_options(const Deck& deck) {
  std::vector<Deck> decks;
  for (int k = 0; k < 32; ++k) {
    Deck d = (k & 1) != 0 ? with_hooke(deck) : deck;
    d.contact.attraction = (k & 2) == 0;
    d.contact.tangential_spring = (k & 4) != 0 ? TangentialSpring::rotated : TangentialSpring::projected;
    d.contact.rolling_history = (k & 8) != 0 ? RollingHistory::rotated : RollingHistory::fixed;
    d.time.integrator = (k & 16) != 0 ? Integrator::synchronised_verlet : Integrator::velocity_verlet;
    decks.push_back(d);
  }
  return decks;
}

/// `deck` with cohesion by areas, EPSD and friction without history.
inline Deck with_cohesive_models(Deck deck) {
  deck.contact.cohesion = Cohesion::sjkr;
  deck.contact.rolling_model = RollingModel::epsd;
  deck.contact.tangential_spring = TangentialSpring::none;
  for (PairDeck& pair : deck.pairs) {
    pair.cohesion_energy_density = 1e5;
    pair.rolling_viscous_damping = 0.3;
  }
  return deck;
}

/// `deck` with JKR adhesion and CDT.
inline Deck with_adhesion(Deck deck) {
  deck.contact.normal_law = NormalLaw::jkr;
  deck.contact.rolling_model = RollingModel::cdt;
  for (PairDeck& pair : deck.pairs) pair.work_of_adhesion = 0.005;
  return deck;
}

/// `deck` with liquid bridges.
inline Deck with_bridges(Deck deck) {
  deck.contact.cohesion = Cohesion::capillary;
  for (PairDeck& pair : deck.pairs) {
    pair.surface_tension = 0.02;
    pair.contact_angle = 30.0;
    pair.bridge_volume = 1e-15;
  }
  return deck;
}

/// `deck` with each contact model that is none of those options, alone and with others.
inline std::vector<Deck> decks_of_all_models(const Deck& deck) {
  std::vector<Deck> decks;
  const auto add = [&](const auto& change) {
    Deck d = deck;
    change(d.contact, d.pairs);
    decks.push_back(d);
  };
  const auto set = [](std::vector<PairDeck>& pairs, double PairCoefficients::*member, double value) {
    for (PairDeck& pair : pairs) pair.*member = value;
  };
  add([](ContactDeck& c, auto&) { c.tangential_spring = TangentialSpring::none; });
  add([](ContactDeck& c, auto&) { c.tangential_damping = TangentialDamping::none; });
  add([](ContactDeck& c, auto&) { c.tangential_damping = TangentialDamping::normal; });
  add([](ContactDeck& c, auto&) { c.rolling_model = RollingModel::cdt; });
  add([&](ContactDeck& c, auto& pairs) {
    c.rolling_model = RollingModel::epsd;
    set(pairs, &PairCoefficients::rolling_viscous_damping, 0.3);
  });
  add([](ContactDeck& c, auto&) {
    c.attraction = false;
    c.restitution_correction = false;
  });
  for (const Cohesion cohesion : {Cohesion::sjkr, Cohesion::sjkr2}) {
    for (const bool in_friction : {false, true}) {
      add([&](ContactDeck& c, auto& pairs) {
        c.cohesion = cohesion;
        c.cohesion_in_friction = in_friction;
        set(pairs, &PairCoefficients::cohesion_energy_density, 2e5);
      });
    }
  }
  add([](ContactDeck& c, auto&) {
    c.normal_law = NormalLaw::hooke;
    c.hooke_characteristic_velocity = 2.0;
  });
  add([&](ContactDeck& c, auto& pairs) {
    c.normal_law = NormalLaw::hooke;
    set(pairs, &PairCoefficients::hooke_stiffness, 400.0);
    set(pairs, &PairCoefficients::hooke_damping_rate, 800.0);
    set(pairs, &PairCoefficients::hooke_tangential_damping_rate, 300.0);
    set(pairs, &PairCoefficients::restitution, unset);
  });
  add([&](ContactDeck& c, auto& pairs) {
    c.normal_law = NormalLaw::jkr;
    c.rolling_model = RollingModel::epsd;
    c.rolling_history = RollingHistory::rotated;
    set(pairs, &PairCoefficients::work_of_adhesion, 0.05);
    set(pairs, &PairCoefficients::rolling_viscous_damping, 0.3);
  });
  decks.push_back(with_bridges(deck));
  return decks;
}

/// `deck` with none of the defaults.
inline Deck with_all_options(const Deck& deck) { return decks_of_all_options(deck).back(); }

}  // namespace repose::test
