#include "thermal/tools/tps_tool.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/distributions.h"
#include "base/error.h"
#include "thermal/moments.h"
#include "thermal/plane_source/tps_deck.h"

namespace repose::thermal {
namespace {

Json json_of(const Estimate& e) {
  return {{"value", e.value}, {"standard_error", e.standard_error}, {"low_95", e.low}, {"high_95", e.high}};
}

Json json_of(const Criterion& c) {
  return {{"name", c.name},
          {"is_met", c.is_met},
          {"value", c.value && std::isfinite(*c.value) ? Json(*c.value) : Json(nullptr)},
          {"wanted", c.wanted}};
}

TpsSetup setup_of(const TpsDeck& deck, const Transient& transient, const std::string& name) {
  TpsSetup setup{.radius = deck.sensor.radius,
                 .power = deck.evaluation.power,
                 .power_deviation = deck.evaluation.power_deviation,
                 .radius_deviation = deck.sensor.radius_deviation,
                 .first = static_cast<std::size_t>(deck.evaluation.first),
                 .last = static_cast<std::size_t>(deck.evaluation.last)};
  if (!transient.power.empty()) {
    setup.power = mean_of(used(transient.power, setup));  // where none are used fit_transient refuses them
  } else if (setup.power <= 0.0) {
    throw DeckError(fmt::format("{}: has no column power, and the deck no evaluation.power; give one", name));
  }
  return setup;
}

Json evaluate(const TpsDeck& deck, const SourceFunction& source, const DataFile& file) {
  const Transient transient = parse_transient(file, deck.sensor.thermometer);
  const TpsSetup setup = setup_of(deck, transient, file.name);
  const TpsFit fit = fit_transient(transient, setup, source, file.name);
  Json criteria = Json::array();
  bool all_met = true;
  for (const Criterion& c : check_criteria(transient, setup, fit, deck.limits)) {
    criteria.push_back(json_of(c));
    all_met = all_met && c.is_met;
  }
  Json json = {{"file", file.name},
               {"power_W", setup.power},
               {"conductivity_W_mK", json_of(fit.conductivity)},
               {"diffusivity_m2_s", json_of(fit.diffusivity)},
               {"volumetric_heat_J_m3K", json_of(fit.volumetric_heat)}};
  if (const double density = deck.evaluation.bulk_density; density > 0.0) {
    const Estimate& c = fit.volumetric_heat;
    json["specific_heat_J_kgK"] =
        json_of(Estimate{c.value / density, c.standard_error / density, c.low / density, c.high / density});  // (A.5)
  }
  json.update(Json{{"contact_K", fit.intercept},
                   {"mean_deviation_K", fit.mean_deviation},
                   {"time_over_characteristic", fit.characteristic},
                   {"iterations", fit.iterations},
                   {"all_criteria_met", all_met},
                   {"criteria", criteria}});
  json["series"] = {{"time_s", transient.time},
                    {"rise_K", transient.rise},
                    {"first_used", setup.first},
                    {"source", fit.source},
                    {"residual_K", fit.residual}};
  return json;
}

/// Mean and scatter of one figure over the files, with the 95 % interval of the mean.
Json scatter_of(const Json& results, const char* figure) {
  std::vector<double> values;
  for (const Json& r : results) values.push_back(r[figure]["value"].get<double>());
  const Moments m = moments_of(values);
  const double half = student_quantile(0.975, m.count - 1.0) * std::sqrt(m.squared_error());
  return {
      {"mean", m.mean}, {"standard_deviation", m.deviation()}, {"low_95", m.mean - half}, {"high_95", m.mean + half}};
}

Json repeats_of(const RepeatsDeck& deck, const Json& results) {
  const auto count = std::ssize(results);
  if (!deck.starts.empty() && std::ssize(deck.starts) != count) {
    throw DeckError(
        fmt::format("[repeats] starts has {} times for {} files; give one for each", deck.starts.size(), count));
  }
  std::vector<double> starts = deck.starts;
  std::sort(starts.begin(), starts.end());
  bool are_apart = !starts.empty();
  for (std::size_t i = 1; i < starts.size(); ++i) are_apart = are_apart && starts[i] - starts[i - 1] >= deck.interval;
  Json json = {{"files", count},
               {"is_met", count >= deck.min && are_apart},
               {"wanted", fmt::format("at least {} measurements, {} s from one to the next{}", deck.min, deck.interval,
                                      starts.empty() ? "; the deck does not say when they began" : "")}};
  if (count < 2) return json;
  for (const char* figure : {"conductivity_W_mK", "diffusivity_m2_s", "volumetric_heat_J_m3K"})
    json[figure] = scatter_of(results, figure);
  return json;
}

std::string source_text(const Json& result) {
  const auto line = [&](const char* key, const char* shown) {
    const Json& e = result[key];
    return fmt::format("{:<26} {:.5g} +- {:.2g}, 95 %: {:.5g} to {:.5g}\n", shown, e["value"].get<double>(),
                       e["standard_error"].get<double>(), e["low_95"].get<double>(), e["high_95"].get<double>());
  };
  std::string text = result["file"].get<std::string>() + "\n";
  text += line("conductivity_W_mK", "conductivity, W/(m K)") + line("diffusivity_m2_s", "diffusivity, m2/s") +
          line("volumetric_heat_J_m3K", "heat capacity, J/(m3 K)");
  if (result.contains("specific_heat_J_kgK")) text += line("specific_heat_J_kgK", "specific heat, J/(kg K)");
  for (const Json& c : result["criteria"]) {
    const std::string value = c["value"].is_null() ? "none" : fmt::format("{:.4g}", c["value"].get<double>());
    text += fmt::format("{} {:<17} {:>10}  ({})\n", c["is_met"].get<bool>() ? "met   " : "BROKEN",
                        c["name"].get<std::string>(), value, c["wanted"].get<std::string>());
  }
  return text;
}

std::string repeats_text(const Json& repeats) {
  std::string text = fmt::format("{} {:<17} {:>10}  ({})\n", repeats["is_met"].get<bool>() ? "met   " : "BROKEN",
                                 "repeats", repeats["files"].get<int>(), repeats["wanted"].get<std::string>());
  if (repeats.contains("conductivity_W_mK")) {
    const Json& k = repeats["conductivity_W_mK"];
    text += fmt::format("mean conductivity {:.5g} W/(m K), standard deviation {:.2g}\n", k["mean"].get<double>(),
                        k["standard_deviation"].get<double>());
  }
  return text;
}

}  // namespace

ToolResult tps_tool(const ToolInput& input) {
  const TpsDeck deck = read_tps_deck(input);
  const SourceFunction source = source_of(deck.sensor);
  Json results = Json::array();
  ToolResult result;
  for (const DataFile& file : input.files) {
    results.push_back(evaluate(deck, source, file));
    result.text += source_text(results.back()) + "\n";
  }
  const Json repeats = repeats_of(deck.repeats, results);
  result.text += repeats_text(repeats);
  result.json = {{"tool", "tps"}, {"title", deck.title}, {"transients", results}, {"repeats", repeats}};
  return result;
}

ToolResult synthesise_tool(const ToolInput& input) {
  const TpsDeck deck = read_tps_deck(input);
  if (!deck.synthetic.enabled) throw DeckError(input.deck.name + ": nothing to synthesise: there is no [synthetic]");
  if (deck.evaluation.power <= 0.0) throw DeckError(input.deck.name + ": [evaluation] lacks \"power\"");
  const SyntheticTransient& s = deck.synthetic.transient;
  const SourceFunction source = source_of(deck.sensor);
  const double tau = std::sqrt(s.duration * s.conductivity / s.volumetric_heat) / s.radius;
  if (tau <= source.least_tau()) {
    throw DeckError(fmt::format("{}: synthetic.duration = {} s is tau = {:.3g}, not above \"cutoff\" = {} of [sensor]",
                                input.deck.name, s.duration, tau, source.least_tau()));
  }
  if (tau > SourceFunction::max_tau) {
    throw DeckError(fmt::format("{}: synthetic.duration = {} s is tau = {:.3g}; at most {} is tabulated",
                                input.deck.name, s.duration, tau, SourceFunction::max_tau));
  }
  const Transient transient = synthesise(s, source);
  const double sample = sample_rise(s, source, s.duration);
  const double contact =
      is_layered(s) ? spiral_rises(s, source, {s.duration})[0] - sample : contact_rise(s, s.duration);
  ToolResult result;
  result.tables.push_back({"transient.csv", transient_csv(transient, s.power)});
  result.json = {{"tool", "synthesise"},
                 {"title", deck.title},
                 {"conductivity_W_mK", s.conductivity},
                 {"diffusivity_m2_s", s.conductivity / s.volumetric_heat},
                 {"volumetric_heat_J_m3K", s.volumetric_heat},
                 {"power_W", s.power},
                 {"sample_rise_K", sample},
                 {"contact_rise_K", contact},
                 {"time_over_characteristic", tau * tau},
                 {"time_s", transient.time},
                 {"rise_K", transient.rise}};
  result.text = fmt::format("{} points to {} s: the sample rises by {:.4g} K, the contact adds {:.4g} K\n", s.points,
                            s.duration, sample, contact);
  return result;
}

}  // namespace repose::thermal
