#include "campaign/posterior_report.h"

#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "deck/study_schema.h"
#include "files/json_text.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

constexpr double strong = 0.8;   // a correlation of which a person should know
constexpr double far_off = 2.0;  // from a prior, in its standard deviations

std::string remark_of(const Marginal& m) {
  const std::string ranges = m.separate ? ", in separate ranges" : "";
  if (!m.determined) return ranges + ", as wide as its prior";
  if (std::fabs(m.off_prior) < far_off) return ranges;
  return fmt::format("{}, {:.1f} standard deviations {} its prior", ranges, std::fabs(m.off_prior),
                     m.off_prior > 0.0 ? "above" : "below");
}

}  // namespace

std::string interval_text(const ConfidenceInterval& i) {
  return fmt::format("{}{:.4g} to {}{:.4g}", i.open_below ? "below " : "", i.lower, i.open_above ? "above " : "",
                     i.upper);
}

Json interval_json(const ConfidenceInterval& i) {
  return {{"lower", i.lower}, {"upper", i.upper}, {"open_below", i.open_below}, {"open_above", i.open_above}};
}

std::string posterior_text(const CalibrationDeck& deck, const Estimate& estimate) {
  const Posterior& posterior = *estimate.posterior;
  const std::vector<double>& best = estimate.points.front().values;
  std::string text;
  for (std::size_t j = 0; j < best.size(); ++j) {
    const Marginal& m = posterior.marginals[j];
    text += fmt::format("  {:24} best {:.4g}; {:.4g} +- {:.2g}, {:.0f} % interval {}{}\n",
                        deck.study.parameters[j].name, best[j], m.mean, m.deviation, 100.0 * posterior.confidence,
                        interval_text(m.interval), remark_of(m));
  }
  for (Index a = 0; a < posterior.correlations.rows(); ++a) {
    for (Index b = 0; b < a; ++b) {
      const double correlation = posterior.correlations(a, b);
      if (std::fabs(correlation) < strong) continue;
      text += fmt::format("  {} and {} go together: correlation {:+.2f}\n",
                          deck.study.parameters[static_cast<std::size_t>(b)].name,
                          deck.study.parameters[static_cast<std::size_t>(a)].name, correlation);
    }
  }
  return text;
}

Json prior_json(const ParameterDeck& p) {
  Json json = {{"kind", enumerators(p.prior).at(static_cast<std::size_t>(p.prior))}};
  if (p.prior == ParameterPrior::uniform) return json;
  json["mean"] = p.prior_mean;
  json["deviation"] = p.prior_deviation;
  return json;
}

Json posterior_json(const Posterior& posterior) {
  Json marginals = Json::array();
  for (const Marginal& m : posterior.marginals) {
    marginals.push_back({{"mean", m.mean},
                         {"deviation", m.deviation},
                         {"median", m.median},
                         {"interval", interval_json(m.interval)},
                         {"prior_deviation", m.prior_deviation},
                         {"off_prior", json_number(m.off_prior)},
                         {"determined", m.determined}});
    if (m.separate) marginals.back()["separate"] = true;
  }
  Json correlations = Json::array();
  for (Index row = 0; row < posterior.correlations.rows(); ++row) {
    Json list = Json::array();
    for (Index column = 0; column < posterior.correlations.cols(); ++column) {
      list.push_back(json_number(posterior.correlations(row, column)));
    }
    correlations.push_back(std::move(list));
  }
  return {{"samples", posterior.samples.rows()},
          {"stages", posterior.stages},
          {"acceptance", posterior.acceptance},
          {"log_density_limit", json_number(posterior.limit)},
          {"marginals", marginals},
          {"correlations", correlations}};
}

std::string posterior_csv(const CalibrationDeck& deck, const Posterior& posterior) {
  std::string text;
  for (const ParameterDeck& p : deck.study.parameters) text += p.name + ",";
  text += "log_density\n";
  for (Index i = 0; i < posterior.samples.rows(); ++i) {
    for (Index j = 0; j < posterior.samples.cols(); ++j) {
      text += fmt::format("{:.8g},", posterior.samples(i, j));
    }
    text += fmt::format("{:.8g}\n", posterior.log_density[i]);
  }
  return text;
}

}  // namespace repose
