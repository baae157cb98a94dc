// The conductivity of networks of grains against hand calculations.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/math.h"
#include "base/philox.h"
#include "heat/air.h"
#include "heat/gap_conductance.h"
#include "thermal/beds/bed_conductivity.h"
#include "thermal/beds/network.h"
#include "thermal/tools/network_tool.h"
#include "thermal_files.h"

namespace repose::thermal {
namespace {

constexpr double d = 0.4e-3;  ///< diameter and distance of the centres, m

/// A lattice of `cells` cubic cells of edge `edge` in x and y and `layers` in z, with the points of `basis` in each
/// cell in units of the edge.
std::vector<Grain> lattice(double edge, const std::vector<Point>& basis, int cells, int layers) {
  std::vector<Grain> grains;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < layers; ++k)
        for (const Point& b : basis)
          grains.push_back({{(i + b[0]) * edge, (j + b[1]) * edge, (k + b[2]) * edge}, 0.5 * d, 0});
  return grains;
}

struct Lattice {
  const char* name;
  double edge;
  std::vector<Point> basis;
  double contacts;  ///< of a grain
  double factor;    ///< k d/C by hand
  double solid;     ///< share of the volume, for grains that touch
};

/// By hand, along a cubic axis, with the conductance C of a contact and a gradient of 1 K/m: between two planes all
/// grains of one plane have the same temperature. Simple cubic: a chain of C for each d^2, over d: k = C/d.
/// Body-centred: each grain has 4 contacts to the next plane, a/2 away, one grain for each a^2: k = 4 C (a/2)/a^2 = 2
/// C/a with a = 2 d/sqrt(3). Face-centred: each grain has 4 contacts to the next plane, a/2 away, one grain for each
/// a^2/2, those within a plane carry nothing: k = 4 C (a/2)/(a^2/2) = 4 C/a with a = sqrt(2) d.
std::vector<Lattice> lattices() {
  return {{"simple cubic", d, {{0, 0, 0}}, 6, 1.0, pi / 6.0},
          {"body-centred cubic",
           2.0 * d / std::sqrt(3.0),
           {{0, 0, 0}, {0.5, 0.5, 0.5}},
           8,
           std::sqrt(3.0),
           pi * std::sqrt(3.0) / 8.0},
          {"face-centred cubic",
           std::sqrt(2.0) * d,
           {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}},
           12,
           2.0 * std::sqrt(2.0),
           pi / std::sqrt(18.0)}};
}

/// Whole cells across; along z two cells are left to the held grains at either end.
MeasuringBox box_of(double edge, int cells, int layers) {
  const double half = -0.25 * edge;
  return {{half, half, 1.75 * edge}, {half + cells * edge, half + cells * edge, (layers - 2.25) * edge}, 2};
}

TEST(Network, OfCubicLatticesIsAsByHand) {
  constexpr int cells = 4;
  constexpr int layers = 12;
  constexpr double c = 3e-5;  // W/K
  for (const Lattice& l : lattices()) {
    const std::vector<Grain> grains = lattice(l.edge, l.basis, cells, layers);
    const Periods periods{{cells * l.edge, cells * l.edge, 0.0}};
    const std::vector<Link> links = links_of(grains, periods, 0.01);
    const MeasuringBox box = box_of(l.edge, cells, layers);
    const NetworkResult result = conduct(grains, links, std::vector<double>(links.size(), c), box, periods);
    EXPECT_NEAR(result.conductivity, l.factor * c / d, 1e-9 * c / d) << l.name;
    EXPECT_NEAR(result.imbalance, 0.0, 1e-9) << l.name;
    EXPECT_EQ(result.floating, 0U);
    EXPECT_NEAR(porosity_in(grains, box, periods, 400), 1.0 - l.solid, 1e-3) << l.name;
  }
}

/// The lattices are isotropic: along x, with y and z periodic, the same.
TEST(Network, OfALatticeDoesNotDependOnTheDirection) {
  const Lattice l = lattices()[2];
  std::vector<Grain> grains = lattice(l.edge, l.basis, 4, 12);
  for (Grain& g : grains) std::swap(g.centre[0], g.centre[2]);
  const Periods periods{{0.0, 4 * l.edge, 4 * l.edge}};
  MeasuringBox box = box_of(l.edge, 4, 12);
  std::swap(box.min[0], box.min[2]);
  std::swap(box.max[0], box.max[2]);
  box.axis = 0;
  const std::vector<Link> links = links_of(grains, periods, 0.01);
  const NetworkResult result = conduct(grains, links, std::vector<double>(links.size(), 2e-5), box, periods);
  EXPECT_NEAR(result.conductivity, l.factor * 2e-5 / d, 1e-13 / d);
}

/// Planes of two materials, A A B B: the contacts of a chain are C_AA, C_AB, C_BB, C_BA in series, so the temperatures
/// are not those of a uniform gradient and have to be solved for: k d = 4/(1/C_AA + 2/C_AB + 1/C_BB).
TEST(Network, OfPlanesInSeries) {
  std::vector<Grain> grains = lattice(d, {{0, 0, 0}}, 4, 24);
  for (Grain& g : grains) g.material = static_cast<std::size_t>(std::lround(g.centre[2] / d)) / 2 % 2;
  const Periods periods{{4 * d, 4 * d, 0.0}};
  const std::vector<Link> links = links_of(grains, periods, 0.01);
  const double values[] = {1e-5, 2e-5, 7e-5};
  std::vector<double> conductance;
  for (const Link& link : links)
    conductance.push_back(values[grains[link.first].material + grains[link.second].material]);
  // The held planes are 0 and 20, which are alike; what is above 20 is held, too, and carries no part of the measure.
  const MeasuringBox box{{-0.5 * d, -0.5 * d, 0.0}, {3.5 * d, 3.5 * d, 20.0 * d}, 2};
  const NetworkResult result = conduct(grains, links, conductance, box, periods);
  const double series = 4.0 / (1.0 / values[0] + 2.0 / values[1] + 1.0 / values[2]);
  EXPECT_NEAR(result.conductivity, series / d, 1e-8 * series / d);
  EXPECT_NEAR(result.imbalance, 0.0, 1e-8);
}

/// Without periods the sides are adiabatic, and links that leave the box count by the part inside. A box within a
/// lattice measures what the lattice conducts: the middle of 10 x 10 chains, cut between them.
TEST(Network, IsMeasuredInABox) {
  const std::vector<Grain> grains = lattice(d, {{0, 0, 0}}, 10, 12);
  const std::vector<Link> links = links_of(grains, {}, 0.01);
  const MeasuringBox box{{1.5 * d, 2.5 * d, 1.7 * d}, {6.5 * d, 5.5 * d, 8.1 * d}, 2};
  const NetworkResult result = conduct(grains, links, std::vector<double>(links.size(), 1e-5), box, {});
  EXPECT_NEAR(result.conductivity, 1e-5 / d, 1e-9 / d);
}

TEST(Network, LeavesOutWhatFloats) {
  std::vector<Grain> grains = lattice(d, {{0, 0, 0}}, 3, 10);
  grains.push_back({{40 * d, 0.0, 5 * d}, 0.5 * d, 0});
  grains.push_back({{41 * d, 0.0, 5 * d}, 0.5 * d, 0});
  const std::vector<Link> links = links_of(grains, {}, 0.01);
  const MeasuringBox box{{-0.5 * d, -0.5 * d, 1.5 * d}, {2.5 * d, 2.5 * d, 7.5 * d}, 2};
  const NetworkResult result = conduct(grains, links, std::vector<double>(links.size(), 1e-5), box, {});
  EXPECT_EQ(result.floating, 2U);
  EXPECT_EQ(result.held, 36U);
  EXPECT_EQ(result.free, 54U);
  EXPECT_NEAR(result.conductivity, 1e-5 / d, 1e-9 / d);
  expect_deck_error(
      [&] {
        conduct(grains, links, std::vector<double>(links.size(), 1e-5), {{0, 0, -d}, {d, d, 5 * d}, 2}, {});
      },
      "no grain lies below the box");
}

/// All pairs and none twice, against a comparison of all with all, for grains of many sizes with periods.
TEST(LinksOf, AreThoseOfAllPairs) {
  std::vector<Grain> grains;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const auto u = [&](std::uint32_t k) { return uniform(5, i, RandomStream::transient_noise, k); };
    grains.push_back({{8e-3 * u(0), 6e-3 * u(1), 9e-3 * u(2)}, 2e-4 + 4e-4 * u(3), 0});
  }
  const Periods periods{{8e-3, 0.0, 9e-3}};
  const std::vector<Link> links = links_of(grains, periods, 0.5);
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const Link& l : links) found.emplace_back(l.first, l.second);
  std::sort(found.begin(), found.end());
  std::vector<std::pair<std::size_t, std::size_t>> wanted;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    for (std::size_t j = i + 1; j < grains.size(); ++j) {
      double squares = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        double x = std::abs(grains[i].centre[k] - grains[j].centre[k]);
        if (periods.length[k] > 0.0) x = std::min(x, periods.length[k] - x);
        squares += x * x;
      }
      if (std::sqrt(squares) <= 1.25 * (grains[i].radius + grains[j].radius)) wanted.emplace_back(i, j);
    }
  }
  EXPECT_GT(wanted.size(), 500U);
  EXPECT_EQ(found, wanted);
}

/// Grains that conduct perfectly: the columns are gaps of D - s, s = sqrt(R^2 - r^2), from the axis to the rim, so
/// (T.17) is pi k_f (s_rim - R + D ln((D - s_rim)/(D - R))) with D = R + H.
TEST(GapConductance, OfPerfectConductorsIsAClosedForm) {
  const double r = 2e-4;
  for (const double gap : {1e-5, 1e-6, 1e-7}) {
    for (const double porosity : {0.36, 0.48}) {
      const GrainPair pair{.radius_1 = r, .radius_2 = r, .conductivity_1 = 1e9, .conductivity_2 = 1e9, .gap = gap};
      const double height = r + 0.5 * gap;
      const double base = 0.560 * r / std::cbrt(1.0 - porosity);
      const double rim = r * base / std::hypot(base, height);
      const double s = std::sqrt(r * r - rim * rim);
      const double closed = pi * 0.026 * (s - r + height * std::log((height - s) / (height - r)));
      EXPECT_NEAR(gap_conductance(pair, {.conductivity = 0.026}, porosity) / closed, 1.0, 1e-6) << gap;
    }
  }
}

/// The contact's circle in solid alone: 2 k a (Batchelor and O'Brien), with two conductivities their harmonic mean.
TEST(GapConductance, OfTheContactIsTwiceItsRadius) {
  EXPECT_NEAR(contact_conductance({.conductivity_1 = 2.0, .conductivity_2 = 2.0, .contact_radius = 1e-5}), 4e-5, 1e-18);
  EXPECT_NEAR(contact_conductance({.conductivity_1 = 1.0, .conductivity_2 = 3.0, .contact_radius = 1e-5}), 3e-5, 1e-18);
  EXPECT_NEAR(contact_radius(2e-4, 2e-4, 1e-6, 1.0), std::sqrt(1e-4 * 1e-6), 1e-18);
  EXPECT_NEAR(contact_radius(2e-4, 2e-4, 1e-6, 1e-3), 0.1 * std::sqrt(1e-4 * 1e-6), 1e-18);
  EXPECT_EQ(contact_radius(2e-4, 2e-4, -1e-6, 1.0), 0.0);
}

/// What fills the gap: less with a free path, more with radiation, nothing without either gas or radiation; a wide gap
/// with radiation alone conducts h_r times the area of its rim, as the solid is perfect.
TEST(GapConductance, HasSmoluchowskiAndRadiation) {
  GrainPair pair{.radius_1 = 2e-4, .radius_2 = 1e-4, .conductivity_1 = 2.0, .conductivity_2 = 2.0, .gap = 1e-6};
  const double plain = gap_conductance(pair, {.conductivity = 0.026}, 0.4);
  EXPECT_LT(gap_conductance(pair, {.conductivity = 0.026, .free_path = 1e-6}, 0.4), 0.95 * plain);
  EXPECT_GT(gap_conductance(pair, {.conductivity = 0.026, .radiation = 100.0}, 0.4), 1.01 * plain);
  EXPECT_NEAR(radiative_coefficient(1000.0, 1.0, 1.0), 4.0 * 56.70374419, 1e-9);
  EXPECT_NEAR(radiative_coefficient(1000.0, 0.5, 0.5), 4.0 * 56.70374419 / 3.0, 1e-9);
  pair = {.radius_1 = 2e-4, .radius_2 = 2e-4, .conductivity_1 = 1e12, .conductivity_2 = 1e12, .gap = 1e-4};
  const double base = 0.560 * 2e-4 / std::cbrt(0.6);
  const double rim = 2e-4 * base / std::hypot(base, 2.5e-4);
  EXPECT_NEAR(gap_conductance(pair, {.conductivity = 0.0, .radiation = 80.0}, 0.4) / (80.0 * pi * rim * rim), 1.0,
              1e-6);
}

std::string csv_of(const std::vector<Grain>& grains) {
  std::string text = "x,y,z,radius\n";
  for (const Grain& g : grains) text += fmt::format("{},{},{},{}\n", g.centre[0], g.centre[1], g.centre[2], g.radius);
  return text;
}

/// The whole tool on simple and face-centred cubic beds in a CSV, at each temperature. By hand: in a lattice of n
/// grains per volume with links of conductance C that reach z far, k = n/2 sum C z^2 over the links of a grain. Beside
/// the contacts (C_1) the second neighbours, sqrt(2) d away, conduct through their gap (C_2): 8 with z = d in the
/// simple cubic bed, 2 with z = a in the face-centred one.
TEST(NetworkTool, OfCubicBedsIsAsByHand) {
  for (const std::size_t which : {std::size_t{0}, std::size_t{2}}) {
    const Lattice l = lattices()[which];
    std::vector<Grain> grains = lattice(l.edge, l.basis, 5, 10);
    const double radius = 0.5 * d + 1e-8;  // an overlap of 20 nm
    for (Grain& g : grains) g.radius = radius;
    const MeasuringBox box = box_of(l.edge, 5, 10);
    const auto corner = [](const Point& p) { return fmt::format("[{}, {}, {}]", p[0], p[1], p[2]); };
    const Json bed =
        network_tool(example("thermal_network.toml",
                             {"box.min=" + corner(box.min), "box.max=" + corner(box.max), "temperature.count=3"},
                             {{"bed.csv", csv_of(grains)}}))
            .json["beds"][0];
    EXPECT_NEAR(bed["porosity"].get<double>(), 1.0 - l.solid, 2e-3);
    EXPECT_NEAR(bed["contacts_per_grain"].get<double>(), l.contacts, 0.15 * l.contacts);  // fewer at both ends
    EXPECT_EQ(bed["conductivity"].size(), 3U);
    for (const Json& row : bed["conductivity"]) {
      const double t = row["temperature_K"].get<double>();
      const Gas gas = air_at(t, 101325.0);
      GrainPair pair{.radius_1 = radius,
                     .radius_2 = radius,
                     .conductivity_1 = 2.0,
                     .conductivity_2 = 2.0,
                     .gap = -2e-8,
                     .contact_radius = contact_radius(radius, radius, 2e-8, 5e6 / 70e9)};
      const GapFill fill{gas.conductivity, modified_free_path(gas), radiative_coefficient(t, 0.9, 0.9)};
      const double porosity = bed["porosity"].get<double>();
      const double first = contact_conductance(pair) + gap_conductance(pair, fill, porosity);
      pair.gap = std::sqrt(2.0) * d - 2.0 * radius;
      pair.contact_radius = 0.0;
      const double second = gap_conductance(pair, fill, porosity);
      const double by_hand = which == 0 ? (first + 4.0 * second) / d : 4.0 * (first + second) / l.edge;
      EXPECT_NEAR(row["conductivity_W_mK"].get<double>() / by_hand, 1.0, 1e-6) << l.name << t;
      EXPECT_NEAR(row["heat_imbalance"].get<double>(), 0.0, 1e-8);
    }
  }
}

TEST(NetworkTool, RefusesWhatIsNoBed) {
  const auto refused = [](std::vector<std::string> overrides, const std::string& text, const std::string& what) {
    expect_deck_error([&] { network_tool(example("thermal_network.toml", overrides, {{"bed.csv", text}})); }, what);
  };
  const std::string grains = csv_of(lattice(d, {{0, 0, 0}}, 4, 10));
  refused({}, "x,y,z\n", "bed.csv:1");
  refused({"box.max=[0, 0, 0]"}, grains, "each component of \"max\" of [box] must be above that of \"min\"");
  refused({"box.periodic=[\"z\"]"}, grains, "the heat's way cannot be periodic");
  refused({"box.periodic=[]", "box.min=[1, 1, 1]", "box.max=[2, 2, 2]"}, grains,
          "bed.csv: the box has the porosity 1; it must hold a bed");
  refused({}, "x,y,z,radius\n0.006,0,0,1e-4\n", "bed.csv: grain 0 lies at x = 0.006 m, outside the box");
  refused({"box.periodic=[]"}, "x,y,z,radius\n0,0,1e7,1e-4\n",
          "bed.csv: grain 0 lies at z = 10000000 m, outside the box");
  refused({"box.periodic=[]"}, "x,y,z,radius\n0,0,3e-3,1e-4\n0,0,1e5,1e-4\n", "no grain lies below the box");
  refused({"material.carbohsp.conductivity=0"}, grains, "\"conductivity\" = 0 is out of range");
}

}  // namespace
}  // namespace repose::thermal
