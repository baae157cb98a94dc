#include "campaign/curve_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "base/interpolate.h"
#include "deck/nearest.h"
#include "files/text_table.h"

namespace repose {
namespace {

constexpr const char* curve_header = "x,y,deviation";

/// One row of a run's table.
struct Row {
  std::int64_t step;
  double x, y;
  std::size_t line;
};

/// The columns that are asked for, in a header.
struct Columns {
  std::size_t count = 0;  ///< of all; 0: the header is not read yet
  std::size_t step = 0, x = 0, y = 0;
};

std::size_t column(const std::vector<std::string>& names, const std::string& name, const FilePlace& place) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    fail_at(place,
            fmt::format("the run's table has no column \"{}\"; did you mean \"{}\"?", name, nearest(name, names)));
  }
  return static_cast<std::size_t>(found - names.begin());
}

Columns columns_of(std::string_view line, const ObservableDeck& o, bool with_step, const FilePlace& place) {
  std::vector<std::string> names;
  for (const std::string_view name : split_fields(line)) names.emplace_back(name);
  return {.count = names.size(),
          .step = with_step ? column(names, "step", place) : 0,
          .x = column(names, o.x, place),
          .y = column(names, o.y, place)};
}

/// NaN where the table says that there is no value, such as of a wall near which there is no grain.
double value_or_nan(std::string_view field, const std::string& name, const FilePlace& place) {
  return field == "nan" ? std::numeric_limits<double>::quiet_NaN() : parse_number(field, name, place);
}

std::vector<Row> rows_of(std::string_view text, const std::string& file, const ObservableDeck& o, bool with_step) {
  Columns columns;
  std::vector<Row> rows;
  for_each_line(text, file, [&](std::string_view line, const FilePlace& place) {
    if (columns.count == 0) {
      columns = columns_of(line, o, with_step, place);
      return;
    }
    const auto fields = split_fields(line);
    require_fields(fields, columns.count, place);
    const double step = with_step ? parse_number(fields[columns.step], "step", place) : 0.0;
    rows.push_back({static_cast<std::int64_t>(step), parse_number(fields[columns.x], o.x, place),
                    value_or_nan(fields[columns.y], o.y, place), place.line});
  });
  return rows;
}

/// At a step between two rows, or that of the nearest row.
Row row_at(const std::vector<Row>& rows, std::int64_t step) {
  const auto after = std::lower_bound(rows.begin(), rows.end(), step, [](const Row& r, auto s) { return r.step < s; });
  if (after == rows.end()) return rows.back();
  if (after == rows.begin() || after->step == step) return *after;
  const Row& before = *(after - 1);
  const double share = static_cast<double>(step - before.step) / static_cast<double>(after->step - before.step);
  return {step, before.x + share * (after->x - before.x), before.y + share * (after->y - before.y), after->line};
}

/// x at a step before the first row, as it rises to the second.
double x_before(const std::vector<Row>& rows, std::int64_t step) {
  if (rows.size() < 2) return rows.front().x;
  const double share = static_cast<double>(rows[0].step - step) / static_cast<double>(rows[1].step - rows[0].step);
  return rows[0].x - share * (rows[1].x - rows[0].x);
}

/// The rows of a window, x less that of its first step. At either end a row is put between those that stand there; a
/// table that begins within the window, such as one that a measurement begins with its phase, begins as it does.
std::vector<Row> rows_within(const std::vector<Row>& rows, const StepWindow& window) {
  if (rows.empty()) return rows;
  const bool begins_within = rows.front().step > window.first;
  std::vector<Row> result = {begins_within ? rows.front() : row_at(rows, window.first)};
  const double origin = begins_within ? x_before(rows, window.first) : result.front().x;
  for (const Row& row : rows) {
    if (row.step > result.back().step && row.step < window.last) result.push_back(row);
  }
  const Row end = row_at(rows, window.last);
  if (end.step > result.back().step) result.push_back(end);
  for (Row& row : result) row.x -= origin;
  return result;
}

}  // namespace

LaboratoryCurve parse_curve_csv(std::string_view text, const std::string& file) {
  LaboratoryCurve curve;
  bool has_header = false;
  const std::size_t last = for_each_line(text, file, [&](std::string_view line, const FilePlace& place) {
    if (!has_header) {
      has_header = true;
      if (compact(line) != curve_header)
        fail_at(place, fmt::format("the header line reads \"{}\"; it must read {}", line, curve_header));
      return;
    }
    const auto fields = split_fields(line);
    require_fields(fields, 3, place);
    const double x = parse_number(fields[0], "x", place);
    const double y = parse_number(fields[1], "y", place);
    const double deviation = parse_number(fields[2], "deviation", place);
    if (!curve.x.empty() && !(x > curve.x.back()))
      fail_at(place, fmt::format("x = {} is not above the {} before; x must rise", x, curve.x.back()));
    if (!(deviation > 0.0))
      fail_at(place, fmt::format("deviation = {} must be above 0; leave out places that are known exactly", deviation));
    curve.x.push_back(x);
    curve.y.push_back(y);
    curve.deviation.push_back(deviation);
  });
  if (!has_header)
    fail_at({file, std::max<std::size_t>(last, 1)}, fmt::format("the header line must read {}", curve_header));
  if (curve.x.size() < 2) fail_at({file, last}, "a curve takes two lines or more below the header");
  return curve;
}

RunCurve parse_run_curve(std::string_view text, const std::string& file, const ObservableDeck& observable,
                         const StepWindow* window) {
  std::vector<Row> rows = rows_of(text, file, observable, window != nullptr);
  if (window != nullptr) rows = rows_within(rows, *window);
  RunCurve curve;
  for (const Row& row : rows) {
    if (std::isnan(row.y)) continue;
    if (!curve.x.empty() && !(row.x > curve.x.back())) {
      fail_at({file, row.line},
              fmt::format("observable \"{}\": {} does not rise here; compare over a column that does, "
                          "or within a phase",
                          observable.figure, observable.x));
    }
    curve.x.push_back(row.x);
    curve.y.push_back(row.y);
  }
  return curve;
}

std::vector<double> at_places(const RunCurve& curve, const std::string& file, const ObservableDeck& observable) {
  const std::vector<double>& x = observable.laboratory_curve.x;
  constexpr double rounding = 1e-9;  // of the curve's range
  const double slack = rounding * (x.back() - x.front());
  if (curve.x.empty() || x.front() < curve.x.front() - slack || x.back() > curve.x.back() + slack) {
    const std::string reach =
        curve.x.empty() ? "has no rows" : fmt::format("reaches from {:g} to {:g}", curve.x.front(), curve.x.back());
    throw DeckError(
        fmt::format("observable \"{}\": {} has x from {:g} to {:g}, but {} of {} {}; shorten the curve or let the runs "
                    "go on longer",
                    observable.figure, observable.curve, x.front(), x.back(), observable.x, file, reach));
  }
  std::vector<double> y;
  for (const double place : x) y.push_back(interpolate(curve.x, curve.y, place));
  return y;
}

}  // namespace repose
