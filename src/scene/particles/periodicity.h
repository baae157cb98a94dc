#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace repose {

struct DomainDeck;

/// Whether a position is beyond the bounds. One that is NaN is not: a guard finds it (simulation/guards.h).
bool is_outside(const DomainDeck& domain, const Vec3& x);

/// The directions in which the domain repeats itself; none by default. There all positions are multiples of a power of
/// two, so fine that a double near the domain resolves no more, and so coarse that bounds, lengths and positions up to
/// a length beyond the bounds are exact. Then a shift by a length rounds nothing: the state evolves with the same bits
/// whichever image of a particle is kept, and whenever it is brought back into the domain.
class Periodicity {
 public:
  Periodicity() = default;
  /// The bounds are rounded outwards to the grid.
  explicit Periodicity(const DomainDeck& domain);

  bool any() const { return any_; }
  const Vec3& length() const { return length_; }      ///< m; 0 in directions that are not periodic
  const Vec3& rounding() const { return rounding_; }  ///< (way + rounding) - rounding is on the grid; 0: as it was

  /// The domain, without bounds in the periodic directions but that parked particles are outside.
  DomainDeck open_bounds(const DomainDeck& domain) const;

  /// The image in the domain of a position at most a length away from it.
  Vec3 wrapped(const Vec3& x) const {
    if (!any_) return x;
    return {wrapped(x.x, low_.x, high_.x, length_.x), wrapped(x.y, low_.y, high_.y, length_.y),
            wrapped(x.z, low_.z, high_.z, length_.z)};
  }

  /// Whether a position is in the domain and stays there when it moves by less than `distance` (m) in any direction.
  bool stays_inside(const Vec3& x, double distance) const {
    const double d = 1.001 * distance;
    return x.x - d >= low_.x && x.y - d >= low_.y && x.z - d >= low_.z && x.x + d < high_.x && x.y + d < high_.y &&
           x.z + d < high_.z;
  }

  /// The nearest position on the grid, in the domain.
  Vec3 on_grid(const Vec3& x) const;

  /// Calls visit(shift) for every shift by lengths, none included, that takes a position in the domain to within
  /// `distance` (m) of it.
  template <class Visit>
  void for_each_shift(const Vec3& x, double distance, Visit&& visit) const {
    if (!any_) return visit(Vec3{});
    const Shifts along_x(x.x, low_.x, high_.x, length_.x, distance);
    const Shifts along_y(x.y, low_.y, high_.y, length_.y, distance);
    const Shifts along_z(x.z, low_.z, high_.z, length_.z, distance);
    for (const double dx : along_x.values()) {
      for (const double dy : along_y.values()) {
        for (const double dz : along_z.values()) visit(Vec3{dx, dy, dz});
      }
    }
  }

  /// How far particles may be apart, in m, such that none is near two images of another.
  double longest_range() const;

 private:
  /// Shifts along one direction.
  class Shifts {
   public:
    Shifts(double x, double low, double high, double length, double distance) {
      if (x < low + distance) values_[count_++] = length;
      if (x >= high - distance) values_[count_++] = -length;
    }
    std::span<const double> values() const { return {values_.data(), count_}; }

   private:
    std::array<double, 3> values_ = {};
    std::size_t count_ = 1;
  };
  static double wrapped(double x, double low, double high, double length) {
    return x < low ? x + length : x >= high ? x - length : x;
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  bool any_ = false;
  Vec3 low_{-infinite, -infinite, -infinite};
  Vec3 high_{infinite, infinite, infinite};
  Vec3 length_;
  Vec3 spacing_;
  Vec3 rounding_;
};

/// Spheres and, behind them, their images within touching distance of the domain.
struct SpheresWithImages {
  std::vector<Vec3> position;  ///< m
  std::vector<double> radius;  ///< m
  std::vector<std::size_t> original;
};
SpheresWithImages with_images(const Periodicity& periodic, std::span<const Vec3> position,
                              std::span<const double> radius);

/// The longest skin in m with which no particle that reaches at most `reach` m from its centre is listed twice with
/// another; infinite without periodic directions. `further` says what adds to the largest radius, if anything does.
/// DeckError when the domain is less than 5 reaches long.
double longest_skin(const Periodicity& periodic, double reach, std::string_view further = {});

}  // namespace repose
