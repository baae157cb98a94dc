#pragma once

#include <cmath>
#include <cstdint>

#include "base/math.h"
#include "base/vec3.h"

namespace repose::test {

/// Random numbers for test scenes: the same on every rank that draws them in the same order from the same seed.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed) {}

  double operator()(double low, double high);
  std::size_t below(std::size_t n) { return static_cast<std::size_t>((*this)(0.0, static_cast<double>(n))); }
  /// Each component between -size and size.
  Vec3 vector(double size) {
    const double x = (*this)(-size, size);
    const double y = (*this)(-size, size);
    return {x, y, (*this)(-size, size)};
  }
  Vec3 direction() {
    const double z = (*this)(-1.0, 1.0);
    const double angle = (*this)(0.0, 2.0 * pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

}  // namespace repose::test
