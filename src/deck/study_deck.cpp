#include "deck/study_deck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "deck/deck_errors.h"
#include "deck/plain_name.h"

namespace repose {
namespace {

/// Columns of the table of the runs beside parameters and figures.
constexpr std::array<std::string_view, 5> taken_names = {"experiment", "level", "seed", "state", "reason"};

void check_parameter(ParameterDeck& p, const std::string& section, DeckErrors& errors) {
  if (p.points > 0 && !p.values.empty()) {
    errors.add(section + ".points", "\"points\" and \"values\" exclude each other");
    return;
  }
  if (!p.values.empty()) {
    const auto [least, greatest] = std::minmax_element(p.values.begin(), p.values.end());
    if (std::isnan(p.min)) p.min = *least;
    if (std::isnan(p.max)) p.max = *greatest;
    if (*least < p.min || *greatest > p.max) {
      errors.add(section + ".values", fmt::format("\"values\" must lie from min = {} to max = {}", p.min, p.max));
    }
    std::vector<double> sorted = p.values;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
      errors.add(section + ".values", "\"values\" has a value twice");
    }
  }
  if (std::isnan(p.min) || std::isnan(p.max)) {
    errors.add(section, "[[parameter]] lacks \"min\" and \"max\", or \"values\"");
  } else if (!(p.min < p.max)) {
    errors.add(section + ".max", fmt::format("\"max\" = {} must be above \"min\" = {}", p.max, p.min));
  }
}

}  // namespace

void check_study(StudyDeck& study, DeckErrors& errors) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    ParameterDeck& p = study.parameters[i];
    const std::string section = fmt::format("parameter.{}", i);
    check_parameter(p, section, errors);
    check_plain_name(p.name, section + ".name", errors);
    for (std::size_t j = 0; j < i; ++j) {
      const ParameterDeck& other = study.parameters[j];
      if (other.name == p.name)
        errors.add(section + ".name", fmt::format("\"{}\" names another parameter, too", p.name));
      if (other.key == p.key)
        errors.add(section + ".key", fmt::format("\"{}\" is another parameter's key, too", p.key));
    }
    if (std::find(taken_names.begin(), taken_names.end(), p.name) != taken_names.end())
      errors.add(section + ".name", fmt::format("\"{}\" is the name of another column of the tables", p.name));
    if (p.key == "run.seed") errors.add(section + ".key", "\"run.seed\" is set by \"seeds\" and \"first_seed\"");
  }
}

void check_column_names(const StudyDeck& study, std::span<const std::string> figures, DeckErrors& errors) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const std::string& name = study.parameters[i].name;
    if (std::find(figures.begin(), figures.end(), name) == figures.end()) continue;
    errors.add(fmt::format("parameter.{}.name", i), fmt::format("\"{}\" is a figure's name, too", name));
  }
}

void check_priors(const StudyDeck& study, DeckErrors& errors) {
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const ParameterDeck& p = study.parameters[i];
    const std::string section = fmt::format("parameter.{}", i);
    const bool has_mean = !std::isnan(p.prior_mean);
    const bool has_deviation = !std::isnan(p.prior_deviation);
    if (p.prior == ParameterPrior::uniform) {
      if (has_mean || has_deviation)
        errors.add(section + ".prior",
                   "\"prior_mean\" and \"prior_deviation\" take prior = \"normal\" or \"lognormal\"");
      continue;
    }
    if (!has_mean || !has_deviation) {
      errors.add(section + ".prior", "this prior takes \"prior_mean\" and \"prior_deviation\"");
      continue;
    }
    if (p.prior != ParameterPrior::lognormal) continue;
    if (!(p.prior_mean > 0.0)) errors.add(section + ".prior_mean", "must be above 0 for a lognormal prior");
    if (!(p.min > 0.0)) errors.add(section + ".min", "must be above 0 for a lognormal prior");
  }
}

std::vector<double> values_of(const ParameterDeck& p) {
  if (p.points == 0) return p.values;
  std::vector<double> values;
  for (std::int64_t i = 0; i < p.points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(p.points - 1);
    // As short as a person would write it: names of folders and tables carry the values.
    values.push_back(std::stod(fmt::format("{:.12g}", p.min + share * (p.max - p.min))));
  }
  return values;
}

}  // namespace repose
