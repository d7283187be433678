// The program `mortise`.
#include <mpi.h>

#include "mortise/cases/driver/program.hpp"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int status = mortise::program(argc, argv);
  MPI_Finalize();
  return status;
}
