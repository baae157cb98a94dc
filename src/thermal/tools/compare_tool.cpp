#include "thermal/tools/compare_tool.h"

#include <cmath>
#include <limits>
#include <map>

#include <fmt/core.h>

#include "base/error.h"
#include "files/text_table.h"
#include "thermal/equivalence.h"
#include "thermal/moments.h"
#include "thermal/tool_deck.h"

namespace repose::thermal {

constexpr double no_bound = std::numeric_limits<double>::quiet_NaN();

/// A column that is compared, and how far its means may be apart.
struct ComparedFigure {
  std::string column;
  double bound = no_bound;           ///< in the unit of the column
  double relative_bound = no_bound;  ///< or as a share of the mean of A
};

/// A hole that grows with its temperature.
struct OrificeDeck {
  bool enabled = false;
  double diameter = 0.0;        ///< m
  double expansion = 0.0;       ///< 1/K
  double cold = 293.15;         ///< K
  double hot = 0.0;             ///< K
  double smallest_grain = 0.0;  ///< m
  double max_share = 0.5;       ///< of the smallest grain
};

struct CompareDeck {
  std::string title;
  double significance = 0.05;
  std::vector<ComparedFigure> figures;
  OrificeDeck orifice;
};

template <class V>
void describe(V& v, ComparedFigure& f) {
  v("column", f.column, Unit::none, any_value, required, "name in the first line of the CSV files");
  v("bound", f.bound, Unit::none, above(0), optional, "greatest difference of the means, in the unit of the column");
  v("relative_bound", f.relative_bound, Unit::none, above(0), optional, "the same as a share of the mean of A");
}

template <class V>
void describe(V& v, OrificeDeck& o) {
  v("diameter", o.diameter, Unit::metre, above(0), required, "cold");
  v("expansion", o.expansion, Unit::per_kelvin, above(0), required, "coefficient of linear expansion");
  v("cold", o.cold, Unit::kelvin, above(0), optional, "temperature at which the diameter was measured");
  v("hot", o.hot, Unit::kelvin, above(0), required, "temperature of the test");
  v("smallest_grain", o.smallest_grain, Unit::metre, above(0), required, "its diameter");
  v("max_share", o.max_share, Unit::none, above(0), optional, "of the smallest grain that the growth may be");
}

template <class V>
void describe(V& v, CompareDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("significance", d.significance, Unit::none, from_to(1e-6, 0.4), optional, "of each one-sided test");
  v.sections("figure", d.figures, required, "a column to compare");
  v.section("orifice", d.orifice, optional, "a hole that grows with its temperature");
}

namespace {

using NamedColumns = std::map<std::string, std::vector<double>, std::less<>>;

void check(CompareDeck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.figures.size(); ++i) {
    const ComparedFigure& f = deck.figures[i];
    if (std::isnan(f.bound) == std::isnan(f.relative_bound))
      errors.add(fmt::format("figure.{}", i), "[[figure]] needs one of \"bound\" and \"relative_bound\"");
  }
  if (deck.orifice.enabled && deck.orifice.hot < deck.orifice.cold)
    errors.add("orifice.hot", "\"hot\" of [orifice] must not be below \"cold\"");
}

/// The name of a column without the quotes around it.
std::string_view name_of(std::string_view field) {
  const bool is_quoted = field.size() > 1 && field.front() == '"' && field.back() == '"';
  return is_quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

/// The columns of a CSV by name. An empty field is a measurement that was not made.
NamedColumns columns_of(const DataFile& file) {
  std::vector<std::string> names;
  NamedColumns columns;
  const std::size_t last = for_each_line(file.bytes, file.name, [&](std::string_view line, const FilePlace& place) {
    const std::vector<std::string_view> fields = split_fields(line);
    if (names.empty()) {
      for (const std::string_view field : fields) {
        names.emplace_back(name_of(field));
        if (names.back().empty()) fail_at(place, "a column of the header has no name");
        if (!columns.try_emplace(names.back()).second)
          fail_at(place, fmt::format("two columns are named \"{}\"", names.back()));
      }
      return;
    }
    if (fields.size() != names.size())
      fail_at(place, fmt::format("{} values, {} were expected", fields.size(), names.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (!fields[i].empty()) columns[names[i]].push_back(parse_number(fields[i], names[i], place));
  });
  if (names.empty())
    fail_at({file.name, last}, "the file is empty; a header with the names of the columns was expected");
  return columns;
}

const std::vector<double>& column(const NamedColumns& columns, const std::string& name, const DataFile& file) {
  const auto found = columns.find(name);
  if (found == columns.end()) throw DeckError(fmt::format("{}: has no column \"{}\"", file.name, name));
  if (found->second.size() < 2) {
    throw DeckError(fmt::format("{}: column \"{}\" has {} values; two are needed for a scatter", file.name, name,
                                found->second.size()));
  }
  return found->second;
}

Json figure_json(const ComparedFigure& f, const std::vector<double>& a, const std::vector<double>& b,
                 double significance) {
  const double bound = std::isnan(f.bound) ? f.relative_bound * std::abs(mean_of(a)) : f.bound;
  if (bound == 0.0)
    throw DeckError(fmt::format("\"{}\": a relative bound needs a mean of A that is not 0; give a bound", f.column));
  const Equivalence e = compare_means(a, b, bound, significance);
  if (!std::isfinite(e.low) || !std::isfinite(e.high))
    throw DeckError(fmt::format("\"{}\": the values are beyond the range of double precision", f.column));
  const bool is_equivalent = e.p_equivalence < significance;
  const bool is_different = e.p_difference < significance;
  return {{"column", f.column},
          {"repeats_a", a.size()},
          {"repeats_b", b.size()},
          {"mean_a", e.mean_a},
          {"mean_b", e.mean_b},
          {"deviation_a", e.deviation_a},
          {"deviation_b", e.deviation_b},
          {"difference", e.difference},
          {"bound", bound},
          {"low", e.low},
          {"high", e.high},
          {"degrees", e.degrees},
          {"p_equivalence", e.p_equivalence},
          {"p_difference", e.p_difference},
          {"is_equivalent", is_equivalent},
          {"is_different", is_different},
          {"verdict", is_equivalent  ? "equivalent"
                      : is_different ? "different"
                                     : "undecided: more repeats are needed"}};
}

Json orifice_json(const OrificeDeck& o) {
  if (!o.enabled) return nullptr;
  const double growth = thermal_growth(o.diameter, o.expansion, o.hot - o.cold);
  const double share = growth / o.smallest_grain;
  return {{"growth_m", growth},
          {"diameter_hot_m", o.diameter + growth},
          {"smallest_grain_m", o.smallest_grain},
          {"share_of_smallest_grain", share},
          {"max_share", o.max_share},
          {"is_below", share <= o.max_share}};
}

std::string comparison_text(const Json& json) {
  std::string text = fmt::format("A {}, B {}; {:.3g} % significance\n\n", json["a"].get<std::string>(),
                                 json["b"].get<std::string>(), 100.0 * json["significance"].get<double>());
  text += "| figure | A | B | B - A | interval | bound | p | verdict |\n|---|---|---|---|---|---|---|---|\n";
  for (const Json& f : json["figures"]) {
    const auto number = [&](const char* key) { return f[key].get<double>(); };
    text += fmt::format(
        "| {} | {:.4g} +- {:.2g} | {:.4g} +- {:.2g} | {:+.3g} | {:+.3g} to {:+.3g} | {:.3g} | {:.2g} "
        "| {} |\n",
        f["column"].get<std::string>(), number("mean_a"), number("deviation_a"), number("mean_b"),
        number("deviation_b"), number("difference"), number("low"), number("high"), number("bound"),
        number("p_equivalence"), f["verdict"].get<std::string>());
  }
  if (const Json& o = json["orifice"]; !o.is_null()) {
    text += fmt::format("\nthe orifice grows by {:.3g} um, {:.3g} of the smallest grain: {}\n",
                        1e6 * o["growth_m"].get<double>(), o["share_of_smallest_grain"].get<double>(),
                        o["is_below"].get<bool>() ? "below the limit" : "beyond the limit");
  }
  return text;
}

}  // namespace

std::string compare_keys() { return key_reference<CompareDeck>("Keys of a file for repose compare."); }

ToolResult compare_tool(const ToolInput& input) {
  const auto deck = read_tool_deck<CompareDeck>(input, check);
  if (input.files.size() != 2) throw DeckError("compare needs two files");
  const NamedColumns a = columns_of(input.files[0]);
  const NamedColumns b = columns_of(input.files[1]);
  Json figures = Json::array();
  for (const ComparedFigure& f : deck.figures) {
    figures.push_back(
        figure_json(f, column(a, f.column, input.files[0]), column(b, f.column, input.files[1]), deck.significance));
  }
  ToolResult result;
  result.json = {{"tool", "compare"},
                 {"title", deck.title},
                 {"a", input.files[0].name},
                 {"b", input.files[1].name},
                 {"significance", deck.significance},
                 {"figures", figures},
                 {"orifice", orifice_json(deck.orifice)}};
  result.text = comparison_text(result.json);
  return result;
}

}  // namespace repose::thermal
