// One main for every test executable: MPI around GoogleTest, the verdict agreed among the ranks.
#include <iostream>

#include <gtest/gtest.h>
#include <mpi.h>

#if defined(REPOSE_LEAK_CHECK)
#include <sanitizer/lsan_interface.h>
#endif

int main(int argc, char** argv) {
  {
    // Open MPI leaks here and at its end, from plugins that it unloads, whose stacks then have no names.
#if defined(REPOSE_LEAK_CHECK)
    const __lsan::ScopedDisabler leaks_are_not_ours;
#endif
    MPI_Init(&argc, &argv);
  }
  ::testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    delete ::testing::UnitTest::GetInstance()->listeners().Release(
        ::testing::UnitTest::GetInstance()->listeners().default_result_printer());
  }
  int failed = RUN_ALL_TESTS();
  if (failed != 0 && rank != 0) {
    const auto* unit = ::testing::UnitTest::GetInstance();
    for (int s = 0; s < unit->total_test_suite_count(); ++s) {
      const auto* suite = unit->GetTestSuite(s);
      for (int t = 0; t < suite->total_test_count(); ++t) {
        const auto* info = suite->GetTestInfo(t);
        for (int p = 0; p < info->result()->total_part_count(); ++p) {
          const auto& part = info->result()->GetTestPartResult(p);
          if (part.failed()) {
            std::cerr << "rank " << rank << ": " << suite->name() << "." << info->name() << ": " << part.file_name()
                      << ":" << part.line_number() << ": " << part.message() << "\n";
          }
        }
      }
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
#if defined(REPOSE_LEAK_CHECK)
  __lsan_do_leak_check();  // now, and not when the process ends
#endif
  MPI_Finalize();
  return failed;
}
