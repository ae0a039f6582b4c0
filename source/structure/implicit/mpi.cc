#include "structure/implicit/mpi.h"

#include <mpi.h>

#include <cstdlib>

namespace birdstrike
{
  void start_mpi()
  {
    int is_started = 0;
    MPI_Initialized(&is_started);
    if (is_started != 0)
      return;
    // A single process: Open MPI need not start its daemon for it, nor make folders for what ranks share. Those of all
    // such processes have one name, and one that ends takes them from under one that begins.
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    std::atexit([] { MPI_Finalize(); });
  }
} // namespace birdstrike
