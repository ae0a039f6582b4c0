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
    // a single process: Open MPI need not start its daemon for it
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    std::atexit([] { MPI_Finalize(); });
  }
} // namespace birdstrike
