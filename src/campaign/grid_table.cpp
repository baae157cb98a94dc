#include "campaign/grid_table.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/atomic_file.h"
#include "files/hdf5_file.h"

namespace repose {
namespace {

template <class T, class Get>
std::vector<T> column(std::span<const RunRecord> records, Get&& get) {
  std::vector<T> values;
  for (const RunRecord& record : records) values.push_back(get(record));
  return values;
}

/// Row by row.
std::vector<double> parameter_rows(const GridTable& table) {
  std::vector<double> rows;
  for (const StudyRun& run : table.runs) rows.insert(rows.end(), run.values.begin(), run.values.end());
  return rows;
}

std::vector<double> figure_rows(const GridTable& table) {
  std::vector<double> rows;
  for (const RunRecord& record : table.records) {
    for (const std::optional<double>& figure : record.figures) {
      rows.push_back(figure.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  return rows;
}

void write_hdf5(const std::string& path, const GridTable& table) {
  const Communicator self = Communicator::self();
  const std::int64_t count = std::ssize(table.runs);
  std::int64_t longest = 0;
  for (const RunRecord& record : table.records) longest = std::max(longest, std::ssize(record.reason));
  Hdf5File file(self, path, (1 << 20) + (1000 + longest) * count + std::ssize(table.deck));
  const RowBlock rows = {count, 0, count};
  file.write_attribute("/", "deck", table.deck);
  for (const auto& [name, text] : build_fields(table.build)) file.write_attribute("/", "build_" + name, text);
  file.create_group("/runs");
  file.write_rows("/runs/parameters", std::span<const double>(parameter_rows(table)), rows,
                  static_cast<int>(table.parameters.size()));
  file.write_attribute("/runs/parameters", "names", std::span<const std::string>(table.parameters));
  if (!table.figures.empty()) {  // a curve has none before its runs are complete
    file.write_rows("/runs/figures", std::span<const double>(figure_rows(table)), rows,
                    static_cast<int>(table.figures.size()));
    file.write_attribute("/runs/figures", "names", std::span<const std::string>(table.figures));
  }
  std::vector<std::int64_t> seeds;
  std::vector<std::string> folders;
  for (const StudyRun& run : table.runs) {
    seeds.push_back(run.seed);
    folders.push_back("runs/" + run.name);
  }
  const auto texts = [&](const char* name, const std::vector<std::string>& values) {
    file.write_texts(std::string("/runs/") + name, values);
  };
  file.write_rows("/runs/seed", std::span<const std::int64_t>(seeds), rows);
  texts("folder", folders);
  const auto names = [&](const char* name, const std::vector<std::string>& all, std::size_t StudyRun::*place) {
    if (all.empty()) return;
    std::vector<std::string> values;
    for (const StudyRun& run : table.runs) values.push_back(all[run.*place]);
    texts(name, values);
    file.write_attribute(std::string("/runs/") + name, "names", std::span<const std::string>(all));
  };
  names("level", table.levels, &StudyRun::level);
  names("experiment", table.experiments, &StudyRun::experiment);
  texts("state", column<std::string>(table.records, [](const RunRecord& r) { return to_string(r.state); }));
  texts("reason", column<std::string>(table.records, [](const RunRecord& r) { return r.reason; }));
  texts("state_hash", column<std::string>(table.records, [](const RunRecord& r) { return r.state_hash; }));
  file.create_group("/effort");
  const auto wall = column<double>(table.records, [](const RunRecord& r) { return r.wall_seconds; });
  file.write_rows("/effort/wall_seconds", std::span<const double>(wall), rows);
  const auto ranks = column<std::int64_t>(table.records, [](const RunRecord& r) { return r.ranks; });
  file.write_rows("/effort/ranks", std::span<const std::int64_t>(ranks), rows);
  const auto restarts = column<std::int64_t>(table.records, [](const RunRecord& r) { return r.restarts; });
  file.write_rows("/effort/restarts", std::span<const std::int64_t>(restarts), rows);
  file.close();
}

/// In quotes: messages have commas.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string csv_of(const GridTable& table) {
  std::string text = table.experiments.empty() ? "" : "experiment,";
  if (!table.levels.empty()) text += "level,";
  text += fmt::format("{},seed,state,", fmt::join(table.parameters, ","));
  for (const std::string& figure : table.figures) text += figure + ",";
  text += "reason\n";
  for (std::size_t i = 0; i < table.runs.size(); ++i) {
    const RunRecord& record = table.records[i];
    if (!table.experiments.empty()) text += table.experiments[table.runs[i].experiment] + ",";
    if (!table.levels.empty()) text += table.levels[table.runs[i].level] + ",";
    for (const double value : table.runs[i].values) text += fmt::format("{},", value);
    text += fmt::format("{},{},", table.runs[i].seed, to_string(record.state));
    for (const std::optional<double>& figure : record.figures) {
      text += figure ? fmt::format("{},", *figure) : std::string(",");
    }
    text += (record.reason.empty() ? std::string() : quoted(record.reason)) + "\n";
  }
  return text;
}

}  // namespace

void write_grid_table(const std::string& directory, const GridTable& table) {
  write_hdf5(directory + "/grid.h5", table);
  write_text_file(directory + "/grid.csv", csv_of(table));
}

}  // namespace repose
