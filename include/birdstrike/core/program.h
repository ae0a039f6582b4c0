#pragma once

#include <array>
#include <string>

namespace birdstrike
{
  /// Which program computed: what a stored run is compared with before it is taken for one's own.
  struct ProgramIdentity
  {
    std::string version; ///< of the release, "0.1.0"
    std::string
      build; ///< first 16 digits of the linker's build id, which changes with the code; empty if there is none
  };

  const ProgramIdentity &program_identity();

  /// Version, commit, build, compiler, flags and versions of the libraries that the program was compiled with: a line
  /// each.
  std::string describe_program();

  /// Variables by which the usual launchers (Open MPI, MPICH and Intel MPI, PMIx, Slurm) tell a process that it may be
  /// one of several.
  inline constexpr std::array<const char *, 5> launcher_variables{
    {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK", "SLURM_PROCID"}};

  /// Whether one of them is set. A process that was started by itself needs no MPI: its start and end cost 0.3 s, as
  /// much as loading the program.
  bool is_started_by_launcher();
} // namespace birdstrike
