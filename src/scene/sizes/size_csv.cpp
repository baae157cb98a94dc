#include "scene/sizes/size_csv.h"

#include <array>
#include <cmath>

#include <fmt/core.h>

#include "files/text_table.h"

namespace repose {
namespace {

constexpr const char* wanted_header =
    "the header line must read DIAMETER,SHARE with DIAMETER = diameter, diameter_mm or diameter_um and "
    "SHARE = cumulative_mass, cumulative_number, share_mass or share_number";

struct Header {
  double divisor = 0.0;  ///< of the diameters; 0: not read yet
  Weighting by = Weighting::mass;
  bool is_cumulative = false;
  std::string share;
};

Header parse_header(std::string_view line, const FilePlace& place) {
  const std::string text = compact(line);
  const auto names = split_fields(text);
  if (names.size() != 2) fail_at(place, wanted_header);
  Header header;
  header.share = names[1];
  header.divisor = names[0] == "diameter"      ? 1.0
                   : names[0] == "diameter_mm" ? 1e3
                   : names[0] == "diameter_um" ? 1e6
                                               : 0.0;
  header.is_cumulative = names[1].starts_with("cumulative_");
  header.by = names[1].ends_with("_number") ? Weighting::number : Weighting::mass;
  constexpr std::array<std::string_view, 4> known = {"cumulative_mass", "cumulative_number", "share_mass",
                                                     "share_number"};
  bool is_known = false;
  for (const std::string_view name : known) is_known |= names[1] == name;
  if (header.divisor == 0.0 || !is_known) fail_at(place, wanted_header);
  return header;
}

/// The lines of the table so far; each after the first ends a bin.
class Table {
 public:
  explicit Table(const Header& header) : header_(header) {}

  void add(std::string_view line, const FilePlace& place) {
    const auto fields = split_fields(line);
    require_fields(fields, 2, place);
    const double diameter = parse_number(fields[0], "diameter", place) / header_.divisor;
    const double value = parse_number(fields[1], header_.share, place);
    if (!(diameter > diameter_)) {
      fail_at(place, lines_ == 0 ? fmt::format("diameter = {} is not positive", fields[0])
                                 : fmt::format("diameter = {} is not greater than the one before", fields[0]));
    }
    constexpr double least = 1e-12;  // m; the powers of a diameter have to be numbers, too
    constexpr double greatest = 1e3;
    if (diameter < least || diameter > greatest) {
      fail_at(place, fmt::format("diameter = {} is not between {} m and {} m", fields[0], least, greatest));
    }
    if (lines_ == 0 && value != 0.0) {
      fail_at(place, fmt::format("{} = {} of the first line must be 0: its diameter is the lower end of the finest "
                                 "class; add a line for it",
                                 header_.share, fields[1]));
    }
    const double share = header_.is_cumulative ? value - value_ : value;
    if (share < 0.0) {
      fail_at(place, header_.is_cumulative
                         ? fmt::format("{} = {} is less than the one before", header_.share, fields[1])
                         : fmt::format("{} = {} is negative", header_.share, fields[1]));
    }
    if (lines_ > 0) bins.push_back({diameter_, diameter, share});
    total += share;
    diameter_ = diameter;
    value_ = value;
    ++lines_;
  }

  std::vector<SizeBin> bins;
  double total = 0.0;

 private:
  const Header& header_;
  double diameter_ = 0.0;
  double value_ = 0.0;
  std::size_t lines_ = 0;
};

}  // namespace

SizeAnalysis parse_size_csv(std::string_view text, const std::string& file) {
  Header header;
  Table table(header);
  const std::size_t last = for_each_line(text, file, [&](std::string_view line, const FilePlace& place) {
    if (header.divisor == 0.0) {
      header = parse_header(line, place);
    } else {
      table.add(line, place);
    }
  });
  if (header.divisor == 0.0) fail_at({file, last}, wanted_header);
  if (!(table.total > 0.0)) fail_at({file, last}, "the shares add up to 0; expected two lines or more");
  constexpr double slack = 0.02;  // of what is read off a curve
  const bool is_whole = std::fabs(table.total - 1.0) < slack || std::fabs(table.total - 100.0) < 100.0 * slack;
  if (header.is_cumulative && !is_whole) {
    fail_at({file, last}, fmt::format("{} ends at {}; it must come to 1, or to 100", header.share, table.total));
  }
  return {header.by, table.bins};
}

}  // namespace repose
