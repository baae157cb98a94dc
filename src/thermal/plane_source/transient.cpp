#include "thermal/plane_source/transient.h"

#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "files/text_table.h"

namespace repose::thermal {
namespace {

struct Columns {
  bool are_resistances = false;
  bool have_power = false;
};

Columns columns_of(std::string_view line, const FilePlace& place, const Thermometer& thermometer) {
  const std::string header = compact(line);
  Columns columns;
  columns.are_resistances = header.starts_with("time,resistance");
  columns.have_power = header.ends_with(",power");
  if (header != "time,temperature" && header != "time,temperature,power" && header != "time,resistance" &&
      header != "time,resistance,power") {
    fail_at(place, "the first line must be the header time,temperature or time,resistance, then power if it is there");
  }
  if (columns.are_resistances && !(thermometer.resistance > 0.0 && thermometer.coefficient != 0.0))
    fail_at(place, "a column of resistances needs resistance and resistance_coefficient in [sensor] of the deck");
  return columns;
}

void add_row(std::string_view line, const FilePlace& place, const Columns& columns, const Thermometer& thermometer,
             Transient& transient) {
  const std::vector<std::string_view> fields = split_fields(line);
  const std::size_t wanted = columns.have_power ? 3 : 2;
  if (fields.size() != wanted) fail_at(place, fmt::format("{} values, {} were expected", fields.size(), wanted));
  const double time = parse_number(fields[0], "time", place);
  const double last = !transient.time.empty()        ? transient.time.back()
                      : !transient.idle_time.empty() ? transient.idle_time.back()
                                                     : -std::numeric_limits<double>::infinity();
  if (time <= last) fail_at(place, fmt::format("time = {} does not come after {}; sort the rows by time", time, last));
  double rise = parse_number(fields[1], columns.are_resistances ? "resistance" : "temperature", place);
  if (columns.are_resistances) rise = (rise / thermometer.resistance - 1.0) / thermometer.coefficient;  // (5.2)
  const double power = columns.have_power ? parse_number(fields[2], "power", place) : 0.0;
  if (time <= 0.0) {
    transient.idle_time.push_back(time);
    transient.idle_rise.push_back(rise);
    return;
  }
  transient.time.push_back(time);
  transient.rise.push_back(rise);
  if (!columns.have_power) return;
  if (power <= 0.0) fail_at(place, fmt::format("power = {} must be above 0 after time 0", power));
  transient.power.push_back(power);
}

}  // namespace

Transient parse_transient(const DataFile& file, const Thermometer& thermometer) {
  Transient transient;
  std::optional<Columns> columns;
  const std::size_t last = for_each_line(file.bytes, file.name, [&](std::string_view line, const FilePlace& place) {
    if (columns) {
      add_row(line, place, *columns, thermometer, transient);
    } else {
      columns = columns_of(line, place, thermometer);
    }
  });
  if (!columns) fail_at({file.name, last}, "the file is empty; the header time,temperature was expected");
  return transient;
}

std::string transient_csv(const Transient& transient, double power) {
  std::string text = "time,temperature,power\n";
  const auto add = [&](const std::vector<double>& times, const std::vector<double>& rises, double watts) {
    for (std::size_t i = 0; i < times.size(); ++i) text += fmt::format("{},{},{}\n", times[i], rises[i], watts);
  };
  add(transient.idle_time, transient.idle_rise, 0.0);
  add(transient.time, transient.rise, power);
  return text;
}

}  // namespace repose::thermal
