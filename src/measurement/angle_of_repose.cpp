#include "measurement/angle_of_repose.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "base/error.h"
#include "base/math.h"

namespace repose {
namespace {

constexpr double rows_per_diameter = 20.0;
constexpr double most_rows = 5000.0;  // a few tiny grains must not make the image huge

/// The views at i * 180 / n degrees, folded into (-90, 90]: left then stays the side of smaller x in each of them.
double azimuth_of_view(std::size_t i, std::size_t n) {
  const double half_turns = static_cast<double>(i) / static_cast<double>(n);
  return pi * (half_turns > 0.5 ? half_turns - 1.0 : half_turns);
}

double height_of(std::span<const Sphere> pile, double plate_height) {
  double top = plate_height;
  for (const Sphere& grain : pile) top = std::max(top, grain.centre.z + grain.radius);
  return top - plate_height;
}

/// `outwards` is -1 on the left flank, +1 on the right one.
FlankLine fit_flank(const Silhouette& outline, const std::vector<double>& u, double z_from, double z_to,
                    double outwards) {
  std::vector<double> zs, us;
  for (std::size_t row = 0; row < u.size(); ++row) {
    const double z = outline.row_z(row);
    if (z < z_from || z > z_to || std::isnan(u[row])) continue;
    zs.push_back(z);
    us.push_back(u[row]);
  }
  if (zs.size() < 2) {
    throw DeckError(
        "measurement.angle_of_repose: between fit_from and fit_to lie fewer than two image rows of the "
        "pile; fit_to must be greater than fit_from by a grain or more");
  }
  const double z_mid = 0.5 * (z_from + z_to);
  const auto rows = static_cast<Eigen::Index>(zs.size());
  Eigen::MatrixX2d a(rows, 2);
  a.col(0).setOnes();
  a.col(1) = Eigen::Map<const Eigen::VectorXd>(zs.data(), rows).array() - z_mid;
  const Eigen::Vector2d line = a.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(us.data(), rows));
  const double angle = std::atan2(1.0, -outwards * line[1]);
  return {.z_mid = z_mid, .u_mid = line[0], .slope = line[1], .angle_deg = angle * 180.0 / pi};
}

/// Sets stderr_deg and independent_views from the views. The angles over the half turn are a periodic series: after it
/// left and right change places, which their mean does not feel.
void estimate_error(AngleOfRepose& result) {
  const std::size_t n = result.views.size();
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      sum +=
          (result.views[i].mean_deg() - result.mean_deg) * (result.views[(i + lag) % n].mean_deg() - result.mean_deg);
    }
    return sum / static_cast<double>(n);
  };
  const double variance = covariance(0);
  double inflation = 1.0;
  for (std::size_t lag = 1; 2 * lag < n && variance > 0.0; ++lag) {
    const double rho = covariance(lag) / variance;
    if (rho <= 0.0) break;
    inflation += 2.0 * rho;
  }
  result.independent_views = static_cast<double>(n) / inflation;
  result.stderr_deg =
      n > 1 ? std::sqrt(variance / (result.independent_views - 1.0)) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

AngleOfReposeParameters parameters_of(const AngleOfReposeDeck& deck) {
  AngleOfReposeParameters parameters;
  parameters.plate_height = deck.plate_height;
  parameters.axis = deck.axis;
  parameters.fit_from = deck.fit_from;
  parameters.fit_to = deck.fit_to;
  parameters.azimuths = static_cast<std::size_t>(deck.azimuths);
  if (deck.camera == Camera::perspective) {
    parameters.camera_distance = deck.camera_distance;
    parameters.camera_height = deck.camera_height;
  }
  return parameters;
}

View view_at(const AngleOfReposeParameters& parameters, double azimuth) {
  return {.axis = parameters.axis,
          .azimuth = azimuth,
          .camera_distance = parameters.camera_distance,
          .camera_height = parameters.camera_height};
}

FlankView fit_flanks(const Silhouette& outline, double fit_from, double fit_to) {
  const double height = outline.top - outline.base;
  const double z_from = outline.base + fit_from * height;
  const double z_to = outline.base + fit_to * height;
  return {.z_from = z_from,
          .z_to = z_to,
          .left = fit_flank(outline, outline.left, z_from, z_to, -1.0),
          .right = fit_flank(outline, outline.right, z_from, z_to, 1.0)};
}

std::optional<AngleOfRepose> angle_of_repose(std::span<const Sphere> pile, const AngleOfReposeParameters& parameters) {
  if (pile.empty() || parameters.azimuths == 0) return std::nullopt;
  AngleOfRepose result;
  result.pile_height = height_of(pile, parameters.plate_height);
  result.pile_grains = pile.size();
  double smallest = std::numeric_limits<double>::infinity();
  for (const Sphere& grain : pile) {
    smallest = std::min(smallest, 2.0 * grain.radius);
    result.pile_volume += volume(grain);
  }
  const double row_height = std::max(smallest / rows_per_diameter, result.pile_height / most_rows);

  const auto n = static_cast<double>(parameters.azimuths);
  for (std::size_t i = 0; i < parameters.azimuths; ++i) {
    const View view = view_at(parameters, azimuth_of_view(i, parameters.azimuths));
    Silhouette outline = silhouette(project(pile, view), parameters.plate_height, row_height);
    result.views.push_back(fit_flanks(outline, parameters.fit_from, parameters.fit_to));
    result.views.back().azimuth = view.azimuth;
    result.left_deg += result.views.back().left.angle_deg / n;
    result.right_deg += result.views.back().right.angle_deg / n;
    if (i == 0) result.silhouette = std::move(outline);
  }
  result.mean_deg = 0.5 * (result.left_deg + result.right_deg);
  estimate_error(result);
  return result;
}

}  // namespace repose
