#include "thermal/plane_source/layered_source.h"

#include <cmath>

#include "base/math.h"
#include "thermal/gauss.h"
#include "thermal/plane_source/laplace_inversion.h"

namespace repose::thermal {
namespace {

/// Hankel's transform of the heat of a source of unit power, x over the radius (T.22).
double spectrum(const LayeredSetup& setup, double x) {
  if (setup.rings == 0) return 2.0 * ::j1(x) / x;
  const auto m = static_cast<double>(setup.rings);
  double sum = 0.0;
  for (std::int64_t i = 1; i <= setup.rings; ++i) {
    const auto l = static_cast<double>(i);
    sum += l * ::j0(x * l / m);
  }
  const double smear = x * setup.strip_width;
  return 2.0 / (m * (m + 1.0)) * sum * std::exp(-0.5 * smear * smear);
}

/// Where the oscillation of the disc's spectrum begins to be averaged: what is lost is 0 there to the leading order.
constexpr double averaged_from = (163.0 + 0.25) * pi;

/// Ends of the intervals in x = wavenumber times radius, each fit for one Gauss rule: the square of the spectrum has
/// the period pi, and the kernel changes over its own wavenumbers, which may be small.
std::vector<double> interval_ends(const LayeredSetup& setup) {
  std::vector<double> ends = {0.0};
  for (int i = -34; i < 0; ++i) ends.push_back(std::pow(1.5, i));                  // from 1e-6
  const double last = setup.rings == 0 ? averaged_from : 6.0 / setup.strip_width;  // exp(-36) is nothing
  const auto count = static_cast<int>(std::ceil(last - 1.0));
  for (int i = 0; i <= count; ++i) ends.push_back(1.0 + (last - 1.0) * i / count);
  return ends;
}

}  // namespace

LayeredSource::LayeredSource(const LayeredSetup& setup) : setup_(setup) {
  const double radius = setup.radius;
  const Heater& heater = setup.heater;
  heat_ = pi * radius * radius * heater.coverage * heater.thickness * heater.volumetric_heat;
  const auto add = [&](double begin, double end, auto&& squared_spectrum) {
    for (const auto& [place, weight] : gauss_nodes) {
      const double x = begin + place * (end - begin);
      nodes_.push_back({x / radius, weight * (end - begin) * x * squared_spectrum(x) / (4.0 * pi * radius * radius)});
    }
  };
  const std::vector<double> ends = interval_ends(setup);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    add(ends[i - 1], ends[i], [&](double x) {
      const double w = spectrum(setup, x);
      return w * w;
    });
  }
  if (setup.rings > 0) return;
  for (int i = 0; i < 53; ++i) {  // to 1e12
    const double begin = averaged_from * std::pow(1.5, i);
    add(begin, 1.5 * begin, [](double x) { return 4.0 / (pi * x * x * x); });  // J_1^2 is 1/(pi x) on average
  }
}

std::complex<double> LayeredSource::admittance(double wavenumber, std::complex<double> s) const {
  const double k2 = wavenumber * wavenumber;
  std::complex<double> y = setup_.conductivity * std::sqrt(k2 + s * setup_.volumetric_heat / setup_.conductivity);
  for (std::size_t i = setup_.layers.size(); i-- > 0;) {
    const Layer& layer = setup_.layers[i];
    const double along = layer.radial_conductivity > 0.0 ? layer.radial_conductivity : layer.conductivity;
    const std::complex<double> decay = std::sqrt((along * k2 + s * layer.volumetric_heat) / layer.conductivity);
    const std::complex<double> wave = layer.conductivity * decay;
    const std::complex<double> depth = std::tanh(decay * layer.thickness);
    y = wave * (y + wave * depth) / (wave + y * depth);  // (T.24)
  }
  return y;
}

std::complex<double> LayeredSource::impedance(std::complex<double> s) const {
  std::complex<double> sum = 0.0;
  for (const Node& node : nodes_) sum += node.weight / admittance(node.wavenumber, s);  // (T.23)
  return sum / (1.0 + s * heat_ * sum);                                                 // (T.25)
}

std::vector<double> LayeredSource::rises(const std::vector<double>& times, double power) const {
  std::vector<double> rises(times.size());
  std::size_t last = times.size();
  while (last > 0) {
    const LaplaceContour contour(times[last - 1]);
    std::vector<std::complex<double>> transform;
    for (const std::complex<double>& s : contour.points()) transform.push_back(power / s * impedance(s));
    const double begin = times[last - 1] / LaplaceContour::span;
    for (; last > 0 && times[last - 1] >= begin; --last) rises[last - 1] = contour.invert(transform, times[last - 1]);
  }
  return rises;
}

}  // namespace repose::thermal
