#include <benchmark/benchmark.h>

#include "mpi_environment.hpp"

int main(int argc, char** argv) {
  mortise::testing::initialize_mpi(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  MPI_Finalize();
  return 0;
}
