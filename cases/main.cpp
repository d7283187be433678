// The program `mortise`.
#include <mpi.h>

#include <cfenv>
#include <csignal>
#include <cstdlib>

#include "mortise/cases/driver/program.hpp"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is reported like a full disk
  if (!std::getenv("OMPI_COMM_WORLD_SIZE")) {  // not under mpiexec: Open MPI need not look for networks nor start a daemon
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_orte_create_session_dirs", "false", 0);  // processes that start at the same moment would trip over them
  }
  MPI_Init(&argc, &argv);
#ifdef MORTISE_TRAPS
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);  // after MPI_Init, whose transports are not ours to audit
#endif
  const int status = mortise::program(argc, argv);
  MPI_Finalize();
  return status;
}
