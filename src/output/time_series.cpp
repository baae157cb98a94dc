#include "output/time_series.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace repose {

namespace {

std::string text_of(const TimeSeries::Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  return shortest_text(std::get<double>(value));
}

}  // namespace

TimeSeries::TimeSeries(std::string path, const std::vector<std::string>& columns, Existing existing)
    : columns_(columns.size()), file_(std::move(path), fmt::format("{}", fmt::join(columns, ",")), existing) {}

void TimeSeries::append(std::span<const Value> row) {
  if (row.size() != columns_) {
    throw std::logic_error(fmt::format("time series: {} values for {} columns", row.size(), columns_));
  }
  std::vector<std::string> texts;
  for (const Value& value : row) texts.push_back(text_of(value));
  file_.append(fmt::format("{}\n", fmt::join(texts, ",")));
}

}  // namespace repose
