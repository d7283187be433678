// The program `mortise`.
#include <mpi.h>

#include <csignal>

#include "mortise/cases/driver/program.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is reported like a full disk
  MPI_Init(&argc, &argv);
  const int status = mortise::program(argc, argv);
  MPI_Finalize();
  return status;
}
