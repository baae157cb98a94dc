#include "heat/heat_ledger.h"

namespace repose {

std::vector<HeatSum> sum_of(const Communicator& comm, std::span<const HeatSum> here) {
  std::vector<std::int64_t> parts;
  for (const HeatSum& sum : here) parts.insert(parts.end(), {sum.high(), sum.low()});
  comm.sum_elements(std::span(parts));
  std::vector<HeatSum> all;
  for (std::size_t k = 0; k < parts.size(); k += 2) all.push_back(HeatSum::of(parts[k], parts[k + 1]));
  return all;
}

HeatLedger sum_of(const Communicator& comm, const HeatLedger& here) {
  std::vector<HeatSum> sums = {here.brought, here.sources, here.kept, here.left};
  sums.insert(sums.end(), here.walls.begin(), here.walls.end());
  const std::vector<HeatSum> all = sum_of(comm, sums);
  return {all[0], all[1], all[2], all[3], std::vector<HeatSum>(all.begin() + 4, all.end())};
}

}  // namespace repose
