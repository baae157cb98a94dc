#include "scene/sizes/size_report.h"

#include <algorithm>

#include <fmt/core.h>

namespace repose {
namespace {

std::vector<SizeClass> classes_of(const SizeDistribution& asked) {
  std::vector<SizeClass> classes;
  if (asked.is_discrete()) {
    for (const SizeBin& bin : asked.bins()) classes.push_back({bin.low, bin.high});
    return classes;
  }
  constexpr int parts = 10;
  double from = asked.smallest();
  for (int k = 1; k <= parts; ++k) {
    const double to = k == parts ? asked.largest() : asked.mass_quantile(static_cast<double>(k) / parts);
    classes.push_back({from, to});
    from = to;
  }
  return classes;
}

SizeFigures figures_of(const SizeDistribution& asked, std::size_t classes) {
  const std::vector<double> shares =
      asked.is_discrete() ? asked.mass_shares() : std::vector<double>(classes, 1.0 / static_cast<double>(classes));
  return {asked.mass_quantile(0.1), asked.mass_quantile(0.5), asked.mass_quantile(0.9), asked.mean(), shares};
}

SizeFigures figures_of(std::span<const double> radii, const std::vector<SizeClass>& classes) {
  std::vector<double> sorted(radii.begin(), radii.end());
  std::sort(sorted.begin(), sorted.end());
  const auto volume = [](double r) { return r * r * r; };
  double total = 0.0;
  double diameters = 0.0;
  for (const double r : sorted) {
    total += volume(r);
    diameters += 2.0 * r;
  }
  SizeFigures figures;
  figures.mean = diameters / static_cast<double>(sorted.size());
  figures.mass_shares.assign(classes.size(), 0.0);
  double below = 0.0;
  std::size_t at = 0;
  for (const double r : sorted) {
    const double d = 2.0 * r;
    while (at + 1 < classes.size() && d > classes[at].to) ++at;
    figures.mass_shares[at] += volume(r) / total;
    if (below <= 0.1 * total) figures.d10 = d;
    if (below <= 0.5 * total) figures.d50 = d;
    if (below <= 0.9 * total) figures.d90 = d;
    below += volume(r);
  }
  return figures;
}

}  // namespace

SizeReport report_sizes(const std::string& block, const SizeDistribution& asked, std::span<const double> radii) {
  const std::vector<SizeClass> classes = classes_of(asked);
  return {block, classes, figures_of(asked, classes.size()), figures_of(radii, classes)};
}

std::string size_report_text(const SizeReport& report) {
  const auto line = [](const char* name, const SizeFigures& f) {
    return fmt::format("  {:<9} d10 {:.4g}, d50 {:.4g}, d90 {:.4g} um by mass; mean {:.4g} um\n", name, 1e6 * f.d10,
                       1e6 * f.d50, 1e6 * f.d90, 1e6 * f.mean);
  };
  std::string text = fmt::format("sizes       {}\n", report.block);
  text += line("asked", report.asked) + line("realised", report.realised);
  for (std::size_t k = 0; k < report.classes.size(); ++k) {
    const auto& [from, to] = report.classes[k];
    const std::string range =
        from == to ? fmt::format("{:.4g} um", 1e6 * to) : fmt::format("{:.4g} to {:.4g} um", 1e6 * from, 1e6 * to);
    text += fmt::format("  {:<20} {:5.2f} % of the mass asked, {:5.2f} % realised\n", range,
                        100.0 * report.asked.mass_shares[k], 100.0 * report.realised.mass_shares[k]);
  }
  return text;
}

}  // namespace repose
