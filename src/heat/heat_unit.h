#pragma once

#include <cmath>
#include <cstdint>

namespace repose {

/// The heat of a particle is an integer of a unit for the whole run, so that what one gives and another takes is the
/// same to the last bit, and no sum depends on its order. The unit is a power of two of a joule, such that the
/// greatest heat that a particle may have takes 56 bits.
class HeatUnit {
 public:
  explicit HeatUnit(double greatest_heat) { std::frexp(greatest_heat, &exponent_); }
  double joules(double units) const { return std::ldexp(units, exponent_ - 56); }
  /// Joules as units; the exact product of a double and this power of two.
  double per_joule() const { return std::ldexp(1.0, 56 - exponent_); }

 private:
  int exponent_ = 0;
};

/// The greatest heat that may flow between two particles in a thermal step, in units: an eighth of the greatest heat a
/// particle may have.
inline constexpr double greatest_flow = 0x1p53;

/// A sum of heats, which may take more than 64 bits.
class HeatSum {
 public:
  void add(std::int64_t units) {
    low_ += units & mask;
    high_ += (units >> 32) + (low_ >> 32);
    low_ &= mask;
  }
  /// The two parts, which add up separately.
  std::int64_t high() const { return high_; }
  std::int64_t low() const { return low_; }
  static HeatSum of(std::int64_t high, std::int64_t low) {
    HeatSum sum;
    sum.high_ = high + (low >> 32);
    sum.low_ = low & mask;
    return sum;
  }
  double units() const { return std::ldexp(static_cast<double>(high_), 32) + static_cast<double>(low_); }
  bool operator==(const HeatSum&) const = default;

  friend HeatSum operator+(const HeatSum& a, const HeatSum& b) { return of(a.high_ + b.high_, a.low_ + b.low_); }
  friend HeatSum operator-(const HeatSum& a, const HeatSum& b) { return of(a.high_ - b.high_, a.low_ - b.low_); }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("high", self.high_);
    v("low", self.low_);
  }

 private:
  static constexpr std::int64_t mask = 0xffffffff;
  std::int64_t high_ = 0;  ///< in 2^32 units
  std::int64_t low_ = 0;   ///< the rest, 0 to 2^32 - 1
};

}  // namespace repose
