// The contact law, wall and integrator against LIGGGHTS 3.8 (tests/reference/README.md), over the whole length of each
// trace: the greatest difference of a vector, over the greatest magnitude of that vector in the trace.
#include <array>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/liggghts_trace.h"

namespace repose::test {
namespace {

struct TraceRow {
  std::int64_t step;
  std::size_t id;
  Vec3 position, velocity, spin;
};

std::vector<TraceRow> read_trace(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<TraceRow> rows;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    TraceRow r;
    fields >> r.step >> r.id >> r.position.x >> r.position.y >> r.position.z >> r.velocity.x >> r.velocity.y >>
        r.velocity.z >> r.spin.x >> r.spin.y >> r.spin.z;
    rows.push_back(r);
  }
  return rows;
}

Vec3 vector_of(const nlohmann::json& j) { return {j[0], j[1], j[2]}; }

void set_hooke(const nlohmann::json& j, Deck& deck) {
  deck.contact.normal_law = NormalLaw::hooke;
  deck.time.hooke_fraction = 0.1;
  if (j.contains("characteristic_velocity")) {
    deck.contact.hooke_characteristic_velocity = j["characteristic_velocity"];
    deck.contact.tangential_damping = TangentialDamping::normal;
    const bool is_user = j["model"].get<std::string>().find("ktToKnUser on") != std::string::npos;
    for (PairDeck& pair : deck.pairs)
      pair.hooke_tangential_ratio = is_user ? 0.285714286 : 1.0;  // as it is in LIGGGHTS
    return;
  }
  const std::array<double, 4> k = j["kn_kt_gamman_gammat_pp"];
  for (PairDeck& pair : deck.pairs) {
    pair.restitution = unset;
    pair.hooke_stiffness = k[0];
    pair.hooke_tangential_ratio = k[1] / k[0];
    pair.hooke_damping_rate = k[2];
    pair.hooke_tangential_damping_rate = k[3];
  }
}

/// The options that the words of LIGGGHTS's pair_style stand for.
void set_model(const nlohmann::json& j, Deck& deck) {
  if (!j.contains("model")) return;  // the default
  const std::string model = j["model"];
  const auto has = [&](const char* words) { return model.find(words) != std::string::npos; };
  if (has("hooke")) set_hooke(j, deck);
  if (has("tangential no_history")) deck.contact.tangential_spring = TangentialSpring::none;
  if (has("tangential_damping off")) deck.contact.tangential_damping = TangentialDamping::none;
  if (has("limitForce on")) deck.contact.attraction = deck.contact.restitution_correction = false;
  if (has("rolling_friction cdt")) deck.contact.rolling_model = RollingModel::cdt;
  if (has("rolling_friction epsd")) deck.contact.rolling_model = RollingModel::epsd;
  if (has("cohesion")) deck.contact.cohesion = has("sjkr2") ? Cohesion::sjkr2 : Cohesion::sjkr;
  deck.contact.cohesion_in_friction = has("tangential_reduce on");
  for (std::size_t k = 0; k < deck.pairs.size(); ++k) {
    if (!has("rolling_friction")) deck.pairs[k].rolling_friction = 0.0;
    if (has("cohesion")) deck.pairs[k].cohesion_energy_density = j["cohesion_energy_density_pp_pw"][k];
    if (has("epsd")) deck.pairs[k].rolling_viscous_damping = j["rolling_viscous_damping_pp_pw"][k];
  }
}

Deck deck_of(const nlohmann::json& j) {
  Deck deck = bare_deck(coefficients_of(j), j["dt"]);
  set_model(j, deck);
  deck.gravity = vector_of(j["gravity"]);
  if (!j["wall_plane_z"].is_null()) deck.walls.push_back(floor_at(j["wall_plane_z"]));
  return deck;
}

struct Deviation {
  double greatest_difference = 0.0;
  double greatest_magnitude = 0.0;
  void add(const Vec3& ours, const Vec3& theirs) {
    greatest_difference = std::max(greatest_difference, norm(ours - theirs));
    greatest_magnitude = std::max(greatest_magnitude, norm(theirs));
  }
  double relative() const {
    return greatest_magnitude > 0.0 ? greatest_difference / greatest_magnitude : greatest_difference;
  }
};

class LiggghtsTrace : public ::testing::TestWithParam<std::string> {};

TEST_P(LiggghtsTrace, IsFollowedOverItsWholeLength) {
  const std::string base = std::string(REPOSE_SOURCE_DIR) + "/tests/reference/" + GetParam();
  std::ifstream parameters(base + ".json");
  const nlohmann::json j = nlohmann::json::parse(parameters);
  std::vector<Grain> grains;
  for (const auto& p : j["particles"]) {
    grains.push_back({vector_of(p["x"]), vector_of(p["v"]), vector_of(p["w"]), p["r"]});
  }
  const std::vector<TraceRow> trace = read_trace(base + ".csv");
  ASSERT_GT(trace.size(), grains.size());

  Scene scene(deck_of(j), grains);
  Deviation position, velocity, spin;
  for (const TraceRow& row : trace) {
    scene.run(row.step - scene.simulation().steps());
    const Grain ours = scene.grains()[row.id - 1];
    position.add(ours.position, row.position);
    velocity.add(ours.velocity, row.velocity);
    spin.add(ours.spin, row.spin);
  }
  EXPECT_EQ(scene.simulation().steps(), j["steps"].get<std::int64_t>());
  EXPECT_LT(position.relative(), 1e-9);
  EXPECT_LT(velocity.relative(), 1e-9);
  EXPECT_LT(spin.relative(), 1e-9);
  RecordProperty("position", testing::PrintToString(position.relative()));
  RecordProperty("velocity", testing::PrintToString(velocity.relative()));
  RecordProperty("spin", testing::PrintToString(spin.relative()));
  std::cout << "  relative deviation: position " << position.relative() << ", velocity " << velocity.relative()
            << ", spin " << spin.relative() << "\n";
}

INSTANTIATE_TEST_SUITE_P(
    All, LiggghtsTrace,
    ::testing::Values("liggghts/pair_normal_impact", "liggghts/pair_oblique_spin_unequal", "liggghts/three_sphere_heap",
                      "liggghts/wall_oblique_bounce", "liggghts/wall_roll_down_incline", "liggghts/wall_roll_to_rest",
                      "liggghts_models/cdt_pair_oblique", "liggghts_models/cdt_wall_rolls",
                      "liggghts_models/epsd_pair_oblique", "liggghts_models/epsd_wall_rolls",
                      "liggghts_models/no_history_pair_oblique", "liggghts_models/sjkr_pair_sticks",
                      "liggghts_models/sjkr_wall_lands", "liggghts_models/sjkr2_pair_oblique",
                      "liggghts_models/sjkr_reduce_pair_oblique", "liggghts_models/hooke_pair_oblique",
                      "liggghts_models/hooke_two_sevenths_pair_oblique", "liggghts_models/hooke_stiffness_pair_oblique",
                      "liggghts_models/no_damping_pair_oblique", "liggghts_models/limit_force_pair_oblique"),
    [](const auto& test) { return test.param.substr(test.param.find('/') + 1); });

}  // namespace
}  // namespace repose::test
