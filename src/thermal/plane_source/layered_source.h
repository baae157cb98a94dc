#pragma once

#include <complex>
#include <cstdint>
#include <vector>

namespace repose::thermal {

/// A layer between the heater and the sample, the same on both sides and without an edge.
struct Layer {
  double thickness = 0.0;            ///< m
  double conductivity = 0.0;         ///< through it, W/(m K)
  double radial_conductivity = 0.0;  ///< along it, W/(m K); 0: the same
  double volumetric_heat = 0.0;      ///< J/(m3 K)
};

/// The metal of the spiral.
struct Heater {
  double thickness = 0.0;        ///< m; 0: it stores no heat
  double volumetric_heat = 0.0;  ///< J/(m3 K)
  double coverage = 1.0;         ///< share of the disc that the strips cover
};

/// What is heated, and where.
struct LayeredSetup {
  double radius = 0.0;           ///< of the disc, m
  std::int64_t rings = 0;        ///< concentric and equidistant; 0: a homogeneous disc
  double strip_width = 0.0;      ///< of the rings: standard deviation of the heat across a strip, over the radius
  std::vector<Layer> layers;     ///< from the heater outwards
  double conductivity = 0.0;     ///< of the half spaces beyond the layers, W/(m K)
  double volumetric_heat = 0.0;  ///< J/(m3 K)
  Heater heater;
};

/// A plane source within layers (theory T.22 to T.25): axially symmetric conduction, by a Hankel transform over the
/// radius and a Laplace transform over time. Each wavenumber then is a one-dimensional problem, which a transmission
/// line solves in closed form.
class LayeredSource {
 public:
  explicit LayeredSource(const LayeredSetup& setup);

  /// The heater's mean rise in K after each of the ascending `times` in s, > 0, of a constant power in W.
  std::vector<double> rises(const std::vector<double>& times, double power) const;

  /// Laplace's transform of the mean rise over that of the power, in K/W, at s in 1/s.
  std::complex<double> impedance(std::complex<double> s) const;

 private:
  struct Node {
    double wavenumber;  ///< 1/m
    double weight;      ///< of the integral over wavenumbers, 1/m2
  };

  /// Flux into one side over the temperature of its inner face, W/(m2 K).
  std::complex<double> admittance(double wavenumber, std::complex<double> s) const;

  LayeredSetup setup_;
  double heat_;  ///< that the heater stores, J/K
  std::vector<Node> nodes_;
};

}  // namespace repose::thermal
