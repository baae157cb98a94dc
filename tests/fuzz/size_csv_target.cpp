// A sieve or laser analysis.
#include <cmath>

#include "scene/sizes/size_csv.h"
#include "scene/sizes/size_distribution.h"
#include "target.h"

namespace repose::fuzz {

namespace {

void check_quantiles(const SizeAnalysis& analysis) {
  const SizeDistribution sizes(analysis.by, analysis.bins);
  const double smallest = analysis.bins.front().low;
  const double largest = analysis.bins.back().high;
  for (const double u : {0.0, 0.3, 0.5, 0.99, 1.0}) {
    for (const double d : {sizes.quantile(u), sizes.mass_quantile(u)}) {
      expect(d >= smallest && d <= largest, "a quantile lies between the smallest and the largest diameter");
    }
  }
  expect(std::isfinite(sizes.mean_volume()) && sizes.mean_volume() > 0.0, "the mean volume is finite and positive");
}

}  // namespace

bool accepts(std::string_view input) {
  SizeAnalysis analysis;
  if (!is_done([&] { analysis = parse_size_csv(input, "sieves.csv"); })) return false;
  check_quantiles(analysis);
  return true;
}

}  // namespace repose::fuzz
