#include "mortise/grids/core/error.hpp"

#include <mpi.h>

#include <cstdio>
#include <cstdlib>

namespace mortise {

void assertion_failed(const char* expression, const char* file, int line, const std::string& state) {
  int initialized = 0, rank = 0;
  MPI_Initialized(&initialized);
  if (initialized) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::fprintf(stderr, "mortise: internal error on rank %d: %s does not hold (%s:%d) %s\n", rank, expression, file, line,
               state.c_str());
  std::abort();
}

}  // namespace mortise
