// A connected part of a region that is too thin for the lattice; it is followed step by step.
#include <gtest/gtest.h>

#include "calibration/confidence_part.h"
#include "calibration_samples.h"

namespace repose {
namespace {

// A parabola much thinner than a cell is one part, from wherever it is looked at.
TEST(ConfidencePart, OfAThinBandIsOneWhicheverItsSeed) {
  const Residuals band = [](const Vector& x) -> Vector {
    return vector_of({(x[1] - 0.2 - 2.5 * (x[0] - 0.5) * (x[0] - 0.5)) / 2e-4, 0.0});
  };
  const auto about = [&](const Vector& seed) {
    return confidence_part(band, evaluate(band, unit_lattice(2, 61)), seed, 1.0);
  };
  const Vector left = vector_of({0.23, 0.2 + 2.5 * 0.27 * 0.27});
  const Vector right = vector_of({0.71, 0.2 + 2.5 * 0.21 * 0.21});
  const ConfidencePart part = about(left);
  EXPECT_TRUE(leads_to(band, part, right, 1.0));
  EXPECT_TRUE(have_same_extent(part, about(right)));
}

}  // namespace
}  // namespace repose
