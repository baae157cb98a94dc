#include <gtest/gtest.h>

#include "base/error.h"
#include "deck/read_deck.h"
#include "deck_example.h"

namespace repose {
namespace {

/// What is wrong with the example deck after `overrides`.
std::string problem(const std::vector<std::string>& overrides) {
  try {
    read_deck(example_deck, "deck.toml", overrides);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

bool ends_with(const std::string& text, const std::string& end) { return text.ends_with(end); }

TEST(ContactDeck, HookeNeedsAStiffnessOfEveryPair) {
  EXPECT_EQ(problem({"contact.normal_law=hooke", "pair.0.hooke_stiffness=1 kN/m"}),
            "deck.toml:23:1: [[pair]] lacks \"hooke_stiffness\", which contact.normal_law = \"hooke\" needs");
  EXPECT_EQ(problem({"contact.normal_law=hooke", "pair.0.hooke_stiffness=1 kN/m", "pair.1.hooke_stiffness=500"}), "");
}

TEST(ContactDeck, HertzRefusesAStiffness) {
  EXPECT_PRED2(ends_with, problem({"pair.1.hooke_stiffness=500"}),
               "\"hooke_stiffness\" belongs to contact.normal_law = \"hooke\"; set that, or remove this");
}

TEST(ContactDeck, WithoutAttractionRestitutionHasALeastValue) {
  EXPECT_PRED2(ends_with, problem({"contact.attraction=false", "pair.0.restitution=0.04"}),
               "\"restitution\" = 0.04 is less than 0.05, the least with contact.attraction = false");
  EXPECT_EQ(problem({"contact.attraction=false", "pair.0.restitution=0.05"}), "");
  EXPECT_EQ(problem({"pair.0.restitution=0.04"}), "");
}

TEST(ContactDeck, HookeTakesItsStiffnessFromOnePlace) {
  EXPECT_EQ(problem({"contact.normal_law=hooke", "contact.hooke_characteristic_velocity=2 m/s"}), "");
  EXPECT_PRED2(
      ends_with,
      problem(
          {"contact.normal_law=hooke", "contact.hooke_characteristic_velocity=2 m/s", "pair.0.hooke_stiffness=500"}),
      "\"hooke_stiffness\" and contact.hooke_characteristic_velocity both say how stiff the pair is; remove one");
}

TEST(ContactDeck, RefusesCoefficientsThatNothingUses) {
  EXPECT_PRED2(ends_with, problem({"pair.0.work_of_adhesion=50 mJ/m2"}),
               "\"work_of_adhesion\" belongs to contact.normal_law = \"jkr\"; set that, or remove this");
  EXPECT_EQ(problem({"pair.0.work_of_adhesion=50 mJ/m2", "contact.normal_law=jkr"}), "");
  EXPECT_PRED2(
      ends_with, problem({"pair.0.cohesion_energy_density=300 kPa"}),
      "\"cohesion_energy_density\" belongs to contact.cohesion = \"sjkr\" or \"sjkr2\"; set that, or remove this");
  EXPECT_EQ(problem({"pair.0.cohesion_energy_density=300 kPa", "contact.cohesion=sjkr2"}), "");
  EXPECT_PRED2(ends_with, problem({"pair.0.rolling_viscous_damping=0.3"}),
               "\"rolling_viscous_damping\" belongs to contact.rolling_model = \"epsd\"; set that, or remove this");
}

TEST(ContactDeck, TheRollingDashpotIsAShareOfTheCriticalDamping) {
  const auto damped = [](const std::string& share) {
    return problem({"contact.rolling_model=epsd", "pair.0.rolling_viscous_damping=" + share});
  };
  EXPECT_EQ(damped("1"), "");
  EXPECT_PRED2(ends_with, damped("1.5"), "\"rolling_viscous_damping\" = 1.5 is out of range; it must be 0 <= x <= 1");
}

TEST(ContactDeck, RefusesWhatContradictsItself) {
  EXPECT_NE(problem({"contact.normal_law=jkr", "contact.attraction=false"}).find("contradicts"), std::string::npos);
  EXPECT_NE(problem({"contact.normal_law=jkr", "contact.cohesion=sjkr"}).find("adhesion of its own"),
            std::string::npos);
  EXPECT_NE(problem({"contact.cohesion_in_friction=true"}).find("needs contact.cohesion"), std::string::npos);
  EXPECT_EQ(problem({"contact.attraction=false", "contact.restitution_correction=false", "pair.0.restitution=0.01"}),
            "");
  EXPECT_PRED2(
      ends_with, problem({"contact.rolling_model=cdt", "contact.rolling_history=rotated"}),
      "\"rolling_history\" = \"rotated\": contact.rolling_model = \"cdt\" has no history; remove one of the two");
  EXPECT_EQ(problem({"contact.rolling_model=epsd", "contact.rolling_history=rotated"}), "");
}

TEST(ContactDeck, ATangentialDampingRateStandsAlone) {
  const auto problem_with = [](const std::string& damping, const std::string& rate = "300") {
    std::string text = example_deck;
    const std::string restitution = "restitution = 0.9";
    text.replace(text.find(restitution), restitution.size(),
                 "hooke_damping_rate = 800\nhooke_tangential_damping_rate = " + rate);
    try {
      read_deck(text, "deck.toml",
                {"contact.normal_law=hooke", "contact.hooke_characteristic_velocity=2 m/s",
                 "contact.tangential_damping=" + damping});
    } catch (const DeckError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(problem_with("stiffness"), "");
  EXPECT_PRED2(ends_with, problem_with("none"),
               "\"hooke_tangential_damping_rate\" = 300 contradicts contact.tangential_damping = \"none\"; give 0, or "
               "remove the latter");
  EXPECT_EQ(problem_with("none", "0"), "");
  EXPECT_PRED2(ends_with, problem_with("normal"),
               "\"hooke_tangential_damping_rate\" and contact.tangential_damping = \"normal\" both say how the pair is "
               "damped; remove the latter");
}

TEST(ContactDeck, DefaultsAreTheThesis) {
  const Deck deck = read_deck(example_deck, "deck.toml", {});
  EXPECT_EQ(deck.contact.normal_law, NormalLaw::hertz);
  EXPECT_TRUE(deck.contact.attraction);
  EXPECT_EQ(deck.contact.tangential_spring, TangentialSpring::projected);
  EXPECT_EQ(deck.contact.rolling_history, RollingHistory::fixed);
  EXPECT_EQ(deck.time.integrator, Integrator::velocity_verlet);
}

}  // namespace
}  // namespace repose
