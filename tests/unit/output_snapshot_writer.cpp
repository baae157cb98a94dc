// Writes the samples that tests/regression/read_snapshot.py reads: output_snapshot_writer FOLDER
#include <iostream>

#include "base/error.h"
#include "output_samples.h"

int main(int argc, char** argv) {
  const repose::MpiGuard guard(&argc, &argv);
  const repose::Communicator comm(MPI_COMM_WORLD);
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  try {
    for (const std::int64_t total : {0, 1, 100, 300000}) {
      const auto table = repose::sample_table(comm, total, repose::Blocks::none_on_first);
      repose::write_snapshot(comm, folder + "/" + std::to_string(total) + ".hdf", table, repose::sample_header(total));
    }
  } catch (const repose::Error& error) {
    if (comm.is_root()) std::cerr << error.what() << "\n";
    return static_cast<int>(error.code());
  }
  return 0;
}
