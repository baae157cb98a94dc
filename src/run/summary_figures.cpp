#include "run/summary_figures.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "deck/nearest.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::optional<double> figure_in(const Json& summary, const std::string& figure) {
  Json::json_pointer pointer;
  for (std::size_t at = 0; at <= figure.size();) {
    const std::size_t dot = std::min(figure.find('.', at), figure.size());
    pointer /= figure.substr(at, dot - at);
    at = dot + 1;
    if (!summary.contains(pointer)) throw DeckError(fmt::format("figure \"{}\": summary.json has no such key", figure));
    if (summary[pointer].is_null()) return {};
  }
  if (!summary[pointer].is_number()) throw DeckError(fmt::format("figure \"{}\": is not one number", figure));
  return summary[pointer].get<double>();
}

std::optional<double> error_in(const Json& summary, const std::string& figure) {
  std::string name = figure;
  if (name.ends_with(".count")) {
    name.replace(name.size() - 5, 5, "error");
  } else if (name.ends_with("_deg")) {
    name.insert(name.size() - 4, "_stderr");
  } else {
    return {};
  }
  try {
    return figure_in(summary, name);
  } catch (const DeckError&) {
    return {};
  }
}

void require_figure(const Deck& deck, const std::string& figure) {
  std::vector<std::string> all;
  for (const MeasurementKind& kind : measurement_kinds()) {
    for (const Figure& known : kind.figures) {
      if (known.kind != Figure::Kind::number) continue;
      all.push_back(known.key);
      if (known.key != figure) continue;
      if (kind.is_enabled(deck)) return;
      throw DeckError(fmt::format("\"{}\" is measured by [{}], which the base deck lacks", figure, kind.section));
    }
  }
  throw DeckError(
      fmt::format("\"{}\" is no figure that runs have; did you mean \"{}\"?", figure, nearest(figure, all)));
}

}  // namespace repose
