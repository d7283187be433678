// MPI for test programs that are started alone or by mpiexec, as root or not, on a laptop or in a container.
#pragma once

#include <mpi.h>
#include <unistd.h>

#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mortise::testing {

/// Names of all variables of this process's environment.
inline std::set<std::string> environment_names() {
  std::set<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    names.insert(text.substr(0, text.find('=')));
  }
  return names;
}

/// MPI_Init with shared memory only and no daemon (looking for more costs 0.2 s). What Open MPI adds to the environment
/// is removed again, so that tests can start mpiexec and the program itself.
inline void initialize_mpi(int* argc, char*** argv) {
  const std::vector<std::pair<const char*, const char*>> settings = {
      {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
      {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
      {"OMPI_MCA_pml", "ob1"},
      {"OMPI_MCA_btl", "self,vader"},
      {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"},
      {"OMPI_MCA_mpi_yield_when_idle", "1"},
      {"OMPI_MCA_rmaps_base_oversubscribe", "1"}};
  for (const auto& [name, value] : settings) setenv(name, value, 0);
  const std::set<std::string> before = environment_names();
  if (!std::getenv("OMPI_COMM_WORLD_SIZE")) {  // alone: no daemon, nor folders that processes starting together trip over
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_orte_create_session_dirs", "false", 0);
  }
  MPI_Init(argc, argv);
  for (const std::string& name : environment_names())
    if (before.count(name) == 0) unsetenv(name.c_str());
}

}  // namespace mortise::testing
