#include "commands/process.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/core.h>

#include "base/kept_memory.h"

namespace repose {
namespace {

/// Whether mpirun or a batch system has started this process, as their variables tell: Open MPI's, those of PMIx, and
/// those of PMI, which MPICH and SLURM set.
bool is_launched() {
  constexpr std::array names = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"};
  return std::any_of(names.begin(), names.end(), [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

void Process::begin(Need need) {
  if (need == Need::ranks) keep_freed_memory();
  if (need == Need::ranks || is_launched()) {
    mpi_ = std::make_unique<MpiGuard>(argc_, argv_);
    ranks_ = std::make_unique<Communicator>(MPI_COMM_WORLD);
  } else {
    ranks_.reset(new Communicator(Communicator::self()));  // which cannot be moved
  }
}

void Process::say(const std::string& text) const {
  if (ranks_->is_root()) fmt::print("{}", text);
}

StopAsked Process::stop_asked(std::optional<double> time_limit) {
  stop_.set_time_limit(time_limit);
  return [this](double needed) { return stop_.reason(needed); };
}

}  // namespace repose
