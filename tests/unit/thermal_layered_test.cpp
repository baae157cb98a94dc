// A plane source within layers against closed forms. The tolerances are what the quadrature and the inversion leave, or
// the next order of the limit where the test says so.
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "thermal/gauss.h"
#include "thermal/plane_source/laplace_inversion.h"
#include "thermal/plane_source/layered_source.h"
#include "thermal_samples.h"

namespace repose::thermal {
namespace {

LayeredSetup setup_with(const SyntheticTransient& s, std::vector<Layer> layers) {
  return {.radius = s.radius,
          .layers = std::move(layers),
          .conductivity = s.conductivity,
          .volumetric_heat = s.volumetric_heat,
          .heater = {}};
}

/// Times of these tau in a sample.
std::vector<double> times_of(const std::vector<double>& taus, const LayeredSetup& s) {
  std::vector<double> times;
  for (const double tau : taus) times.push_back(tau * tau * s.radius * s.radius * s.volumetric_heat / s.conductivity);
  return times;
}

const Layer mica_layer = {
    .thickness = 120e-6, .conductivity = 0.46, .radial_conductivity = 4.0, .volumetric_heat = 2.3e6};

/// exp(-t), t and erfc(1/(2 sqrt t)), from one end of the span to the other.
TEST(LaplaceContour, InvertsKnownTransforms) {
  const double end = 1.7;
  const LaplaceContour contour(end);
  std::vector<std::complex<double>> decay;
  std::vector<std::complex<double>> ramp;
  std::vector<std::complex<double>> front;
  for (const std::complex<double>& s : contour.points()) {
    decay.push_back(1.0 / (s + 1.0));
    ramp.push_back(1.0 / (s * s));
    front.push_back(std::exp(-std::sqrt(s)) / s);
  }
  for (const double t : {end / LaplaceContour::span, 0.6, 1.0, end}) {
    EXPECT_NEAR(contour.invert(decay, t), std::exp(-t), 1e-11);
    EXPECT_NEAR(contour.invert(ramp, t), t, 1e-11);
    EXPECT_NEAR(contour.invert(front, t), std::erfc(0.5 / std::sqrt(t)), 1e-11);
  }
}

/// Layers of the sample's own properties are sample: the ideal source of (5.3), for all times that are tabulated.
TEST(LayeredSource, OfTheSampleAloneIsTheIdealDisc) {
  const SourceFunction disc = SourceFunction::disc();
  for (const Sample& sample : {steel(), grains()}) {
    const SyntheticTransient& s = sample.measurement;
    const Layer own = {.thickness = 0.3e-3,
                       .conductivity = s.conductivity,
                       .radial_conductivity = s.conductivity,
                       .volumetric_heat = s.volumetric_heat};
    for (const std::vector<Layer>& layers : {std::vector<Layer>{}, std::vector<Layer>{own, own}}) {
      const LayeredSetup setup = setup_with(s, layers);
      const std::vector<double> times = times_of({1e-3, 3e-3, 0.01, 0.02, 0.1, 0.3, 0.7, 1.0, 3.0, 10.0, 90.0}, setup);
      const std::vector<double> rises = LayeredSource(setup).rises(times, s.power);
      for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(rises[i] / sample_rise(s, disc, times[i]), 1.0, 1e-6) << times[i];
    }
  }
}

/// Rings have strips of some width here and begin at the cutoff in (T.2): another constant, and what is left of the
/// beginning, (cutoff/tau)^2.
TEST(LayeredSource, OfTheSampleAloneIsTheIdealRings) {
  const double cutoff = 0.005;
  const SyntheticTransient s = grains().measurement;
  const SourceFunction source = SourceFunction::of_rings(15, cutoff);
  LayeredSetup setup = setup_with(s, {});
  setup.rings = source.rings();
  setup.strip_width = cutoff;
  const std::vector<double> times = times_of({0.1, 0.2, 0.4, 0.8, 1.6}, setup);
  const std::vector<double> rises = LayeredSource(setup).rises(times, s.power);
  const double all = sample_rise(s, source, times.back());
  const double constant = rises.back() - all;
  EXPECT_LT(std::abs(constant), 0.05 * all);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(rises[i] - sample_rise(s, source, times[i]), constant, 2e-4 * all) << times[i];
}

/// One ring with a strip of some width (T.22) in a homogeneous medium, summed over time: the temperature of a ring
/// after an instant is that of a line that has already spread for the time that makes it so wide.
TEST(LayeredSource, OfOneRingIsItsIntegralOverTime) {
  const SyntheticTransient s = grains().measurement;
  LayeredSetup setup = setup_with(s, {});
  setup.rings = 1;
  setup.strip_width = 0.05;
  const double diffusivity = s.conductivity / s.volumetric_heat;
  const std::vector<double> times = times_of({0.03, 0.1, 0.5, 2.0}, setup);
  const std::vector<double> rises = LayeredSource(setup).rises(times, s.power);
  for (std::size_t i = 0; i < times.size(); ++i) {
    constexpr int steps = 2000;
    const double width = std::sqrt(diffusivity * times[i]) / s.radius / steps;  // in sqrt(alpha t)/r
    double sum = 0.0;
    for (int j = 0; j < steps; ++j) {
      sum += gauss_integral(j * width, (j + 1) * width, [&](double tau) {
        const double spread = 2.0 * (tau * tau + setup.strip_width * setup.strip_width);
        return scaled_bessel(0, 1.0 / spread) / spread;
      });
    }
    EXPECT_NEAR(rises[i] / (s.power / (2.0 * pi * std::sqrt(pi) * s.conductivity * s.radius) * sum), 1.0, 1e-6);
  }
}

/// The integral of erfc from x on.
double ierfc(double x) { return std::exp(-x * x) / std::sqrt(pi) - x * std::erfc(x); }

/// Half of the power into a layer on a half space, far from the edge (the radius is 1e7 depths): the sum over images of
/// the face (Carslaw and Jaeger, chapter XII). A second layer is of the sample's own.
TEST(LayeredSource, OfGreatRadiusMeetsTheImagesOfOneDimension) {
  for (const Sample& sample : {steel(), grains()}) {
    SyntheticTransient s = sample.measurement;
    s.radius = 1e5;
    s.power = 2.0 * pi * s.radius * s.radius;  // 1 W/m2
    const Layer& layer = mica_layer;
    const Layer sample_layer = {.thickness = 0.2e-3,
                                .conductivity = s.conductivity,
                                .radial_conductivity = s.conductivity,
                                .volumetric_heat = s.volumetric_heat};
    const double diffusivity = layer.conductivity / layer.volumetric_heat;
    const double own = std::sqrt(layer.conductivity * layer.volumetric_heat);
    const double other = std::sqrt(s.conductivity * s.volumetric_heat);
    const double reflection = (own - other) / (own + other);
    const std::vector<double> times = {0.01, 0.03, 0.1, 0.3, 1.0, 5.0};
    const std::vector<double> rises = LayeredSource(setup_with(s, {layer, sample_layer})).rises(times, s.power);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double depth = std::sqrt(diffusivity * times[i]);
      double images = ierfc(0.0);
      for (int n = 1; n < 500; ++n) images += 2.0 * std::pow(reflection, n) * ierfc(n * layer.thickness / depth);
      EXPECT_NEAR(rises[i] / (2.0 * depth / layer.conductivity * images), 1.0, 1e-6) << times[i];
    }
  }
}

/// A heater that stores heat on a half space, far from the edge.
TEST(LayeredSource, HeaterStoresHeat) {
  SyntheticTransient s = grains().measurement;
  s.radius = 1e5;
  s.power = 2.0 * pi * s.radius * s.radius;
  LayeredSetup setup = setup_with(s, {});
  setup.heater = {.thickness = 10e-6, .volumetric_heat = 4e6, .coverage = 0.5};
  const double stores = 0.5 * 10e-6 * 4e6 / 2.0;  // J/(m2 K) on one side
  const double effusivity = std::sqrt(s.conductivity * s.volumetric_heat);
  const std::vector<double> times = {1e-5, 1e-4, 1e-3, 0.01, 0.1};
  const std::vector<double> rises = LayeredSource(setup).rises(times, s.power);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double u = effusivity * std::sqrt(times[i]) / stores;
    const double rise = 2.0 * std::sqrt(times[i] / pi) / effusivity -
                        stores / (effusivity * effusivity) * (1.0 - std::exp(u * u) * std::erfc(u));
    EXPECT_NEAR(rises[i] / rise, 1.0, 1e-6) << times[i];
  }
}

/// What goes into heater and layers that the heat cannot leave is stored there.
TEST(LayeredSource, KeepsTheEnergy) {
  SyntheticTransient s = grains().measurement;
  s.radius = 1.0;
  s.power = 100.0;
  s.conductivity = 1e-20;
  std::vector<Layer> layers(2, mica_layer);
  for (Layer& layer : layers) layer.radial_conductivity = 1e-15;
  layers[1].volumetric_heat = 1e6;
  LayeredSetup setup = setup_with(s, layers);
  setup.heater = {.thickness = 10e-6, .volumetric_heat = 4e6, .coverage = 0.5};
  const double capacity = pi * (0.5 * 10e-6 * 4e6 + 2.0 * 120e-6 * (2.3e6 + 1e6));  // J/K
  const std::vector<double> rises = LayeredSource(setup).rises({10.0, 25.0, 70.0}, s.power);
  EXPECT_NEAR((rises[1] - rises[0]) * capacity / (s.power * 15.0), 1.0, 1e-6);
  EXPECT_NEAR((rises[2] - rises[0]) * capacity / (s.power * 60.0), 1.0, 1e-6);
}

/// The steady rise of a disc, and what a thin layer adds to it: its resistance, less what it carries outwards (T.26).
/// The next order of the layer is its thickness over the radius times a logarithm; of the time, tau^-3.
TEST(LayeredSource, TendsToTheSteadyRise) {
  const SyntheticTransient s = grains().measurement;
  const double area = pi * s.radius * s.radius;
  const LayeredSetup bare = setup_with(s, {});
  const double steady = 4.0 / (3.0 * pi * pi * s.conductivity * s.radius);
  EXPECT_NEAR(LayeredSource(bare).impedance(1e-30).real() / steady, 1.0, 1e-8);
  for (const double along : {1e-6, 0.46, 4.0}) {
    Layer layer = mica_layer;
    layer.thickness = 1e-6 * s.radius;
    layer.radial_conductivity = along;
    const LayeredSource covered(setup_with(s, {layer}));
    const double wanted =
        layer.thickness / (2.0 * area) * (1.0 / layer.conductivity - along / (s.conductivity * s.conductivity));
    EXPECT_NEAR((covered.impedance(1e-30).real() - LayeredSource(bare).impedance(1e-30).real()) / wanted, 1.0, 1e-3);
    const std::vector<double> late = times_of({50.0}, bare);
    const double rise = steady * (1.0 - 3.0 * std::sqrt(pi) / (16.0 * 50.0)) + wanted;
    EXPECT_NEAR(covered.rises(late, 1.0)[0] / rise, 1.0, 1e-6);
  }
}

/// A layer that heat does not cross is the sample: of other conductivities along and through it, it is the isotropic
/// one of their geometric mean with the radial diffusivity.
TEST(LayeredSource, KnowsAnisotropy) {
  const SourceFunction disc = SourceFunction::disc();
  SyntheticTransient s = grains().measurement;
  Layer thick = mica_layer;
  thick.thickness = 1.0;
  const LayeredSetup setup = setup_with(s, {thick});
  const std::vector<double> times = {0.1, 1.0, 10.0, 100.0};
  const std::vector<double> rises = LayeredSource(setup).rises(times, s.power);
  s.conductivity = std::sqrt(thick.conductivity * thick.radial_conductivity);
  s.volumetric_heat = s.conductivity * thick.volumetric_heat / thick.radial_conductivity;
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(rises[i] / sample_rise(s, disc, times[i]), 1.0, 1e-6) << times[i];
}

}  // namespace
}  // namespace repose::thermal
