#include "measurement_piles.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace repose::test {
namespace {

constexpr double radius = 0.5 * diameter;

/// The hexagonal close packing at contact distance within |x|, |y| <= half and |z| <= half.
std::vector<Vec3> close_packing(double half) {
  const double layer = diameter * std::sqrt(2.0 / 3.0);
  const double row = diameter * std::sqrt(0.75);
  std::vector<Vec3> centres;
  for (int k = -static_cast<int>(half / layer); k * layer <= half; ++k) {
    const bool odd = k % 2 != 0;
    for (int j = -static_cast<int>(half / row); j * row <= half; ++j) {
      for (int i = -static_cast<int>(half / diameter); i * diameter <= half; ++i) {
        const double shift = (j % 2 != 0 ? 0.5 * diameter : 0.0) + (odd ? 0.5 * diameter : 0.0);
        centres.push_back({i * diameter + shift, j * row + (odd ? row / 3.0 : 0.0), k * layer});
      }
    }
  }
  return centres;
}

double distance_from_axis(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// How far p lies below the surface of the heap, along its normal.
double depth(const Vec3& p, double height, double slope) {
  return (height - p.z - slope * distance_from_axis(p)) / std::sqrt(1.0 + slope * slope);
}

Vec3 turned(const Vec3& p, double turn, double tilt) {
  const Vec3 q{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn), p.z};
  return {q.x, q.y * std::cos(tilt) - q.z * std::sin(tilt), q.y * std::sin(tilt) + q.z * std::cos(tilt)};
}

/// The skin, of the directions whose cosine `keeps` accepts.
void add_skin(std::vector<Sphere>& grains, double height, double slope, double skin_diameter,
              const std::function<bool(double)>& keeps) {
  const double skin_radius = 0.5 * skin_diameter;
  const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
  for (double z = skin_radius;; z += skin_diameter * slope * cosine) {
    const double r = (height - z - skin_radius / cosine) / slope;
    if (r < 0.0) break;
    const int count = std::max(1, static_cast<int>(std::ceil(2.0 * pi * r / skin_diameter)));
    for (int k = 0; k < count; ++k) {
      const double phi = 2.0 * pi * k / count;
      if (keeps(std::cos(phi))) grains.push_back({{r * std::cos(phi), r * std::sin(phi), z}, skin_radius});
    }
  }
}

}  // namespace

std::vector<Sphere> heap(double height, const std::function<double(double)>& slope, double skin_diameter) {
  std::vector<Sphere> grains;
  const double half = 1.1 * height / std::min(slope(-1.0), slope(1.0));
  for (const Vec3& p : close_packing(half)) {
    if (p.z >= radius && depth(p, height, slope(p.x)) >= skin_diameter + 0.2 * diameter) grains.push_back({p, radius});
  }
  add_skin(grains, height, slope(-1.0), skin_diameter, [](double x) { return x < 0.0; });
  add_skin(grains, height, slope(1.0), skin_diameter, [](double x) { return x >= 0.0; });
  return grains;
}

std::vector<Sphere> cone(double height, double angle_deg, double skin_diameter) {
  const double slope = std::tan(angle_deg * pi / 180.0);
  return heap(
      height, [slope](double) { return slope; }, skin_diameter);
}

std::vector<Sphere> rough_cone(double height, double angle_deg, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * pi);
  const double turn = angle(random);
  const double tilt = angle(random);
  const double slope = std::tan(angle_deg * pi / 180.0);
  std::vector<Sphere> grains;
  for (const Vec3& lattice : close_packing(1.5 * height / slope)) {
    const Vec3 p = turned(lattice, turn, tilt);
    if (p.z >= radius && depth(p, height, slope) >= radius) grains.push_back({p, radius});
  }
  return grains;
}

void strew(std::vector<Sphere>& grains, int count, double height, double angle_deg, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double slope = std::tan(angle_deg * pi / 180.0);
  for (int k = 0; k < count; ++k) {
    const double phi = 2.0 * pi * share(random);
    const double r = height / slope * std::sqrt(share(random));
    grains.push_back({{r * std::cos(phi), r * std::sin(phi), height - slope * r}, radius});
  }
}

void add_strays(std::vector<Sphere>& grains, int count, double from, double to, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * pi);
  std::uniform_real_distribution<double> distance(from, to);
  for (int k = 0; k < count; ++k) {
    const double phi = angle(random);
    const double r = distance(random);
    grains.push_back({{r * std::cos(phi), r * std::sin(phi), radius}, radius});
  }
}

void add_airborne(std::vector<Sphere>& grains, int count, double height, double reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> across(-reach, reach);
  std::uniform_real_distribution<double> up(2.0 * diameter, height);
  for (int k = 0; k < count;) {
    const Vec3 p{across(random), across(random), up(random)};
    const bool is_free =
        std::all_of(grains.begin(), grains.end(), [&](const Sphere& g) { return norm(g.centre - p) > 2.0 * diameter; });
    if (!is_free) continue;
    grains.push_back({p, radius});
    ++k;
  }
}

}  // namespace repose::test
