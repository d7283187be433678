// Runs the tests of one tier on one rank.
#include <gmock/gmock.h>

#include "mpi_environment.hpp"

int main(int argc, char** argv) {
  ::testing::InitGoogleMock(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  mortise::testing::initialize_mpi(&argc, &argv);
  const int status = RUN_ALL_TESTS();
  MPI_Finalize();
  return status;
}
