#include "campaign/surface_json.h"

#include <functional>

#include <nlohmann/json.hpp>

#include "calibration/contour_lines.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

constexpr int nodes = 61;  // of the lattice, along each parameter

double node(const ParameterRange& range, int k) {
  return range.lower + (range.upper - range.lower) * k / (nodes - 1.0);
}

Vector in_box(double x, double y) {
  Vector point(2);
  point << x, y;
  return point;
}

/// value(point of the box), a row for each y.
Json lattice_of(const std::function<double(const Vector&)>& value) {
  Json rows = Json::array();
  for (int j = 0; j < nodes; ++j) {
    Json row = Json::array();
    for (int i = 0; i < nodes; ++i) row.push_back(value(in_box(i / (nodes - 1.0), j / (nodes - 1.0))));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json lines_of(const std::vector<ContourLine>& lines) {
  Json list = Json::array();
  for (const ContourLine& line : lines) {
    Json points = Json::array();
    for (const PlanePoint& p : line) points.push_back({p.x, p.y});
    list.push_back(std::move(points));
  }
  return list;
}

}  // namespace

Json surface_json(const Misfit& misfit, const CalibrationDeck& deck, double limit) {
  const ParameterRange& x = misfit.ranges()[0];
  const ParameterRange& y = misfit.ranges()[1];
  Json json = {{"x", Json::array()}, {"y", Json::array()}};
  for (int k = 0; k < nodes; ++k) {
    json["x"].push_back(node(x, k));
    json["y"].push_back(node(y, k));
  }
  Json observables = Json::array();
  for (std::size_t k = 0; k < deck.observables.size(); ++k) {
    const ObservableSurface& surface = misfit.surface(static_cast<Index>(k));
    const auto at = [&](double u, double v) {
      return surface.mean(in_box((u - x.lower) / (x.upper - x.lower), (v - y.lower) / (y.upper - y.lower)));
    };
    const auto lines = contour_lines(at, {x.lower, x.upper}, {y.lower, y.upper}, deck.observables[k].laboratory);
    observables.push_back({{"figure", surface.name()},
                           {"mean", lattice_of([&](const Vector& p) { return surface.mean(p); })},
                           {"deviation", lattice_of([&](const Vector& p) { return surface.deviation(p); })},
                           {"laboratory_lines", lines_of(lines)}});
  }
  json["observables"] = observables;
  json["misfit"] = lattice_of([&](const Vector& p) { return misfit(p); });
  json["limit"] = limit;
  return json;
}

}  // namespace repose
