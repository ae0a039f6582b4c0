#pragma once

namespace birdstrike
{
  /// Trilinos needs MPI even on one process. Starts it unless a launcher has (main), once, and ends it with the
  /// program; runs without implicit solves never do, and save its tenth of a second.
  void start_mpi();
} // namespace birdstrike
