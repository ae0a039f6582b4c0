#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/contact/parameters.h>
#include <birdstrike/io/output_parameters.h>
#include <birdstrike/io/parameter_file.h>
#include <birdstrike/io/study_parameters.h>
#include <birdstrike/material/equation_of_state.h>
#include <birdstrike/structure/parameters.h>
#include <birdstrike/time_control/parameters.h>

#include <array>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A bird of the scene, and its liquid.
  struct BirdCase
  {
    unsigned int          number; ///< 1: section Bird, k: section Bird k
    const BirdParameters &bird;
    const EosParameters  &liquid;
  };

  /// Everything one case is made of. The members are bound to `file`, so the object can neither be copied nor moved.
  struct CaseParameters
  {
    std::string name;                       ///< empty in the file: the file's name without ".prm"
    std::string description;                ///< one sentence
    bool        has_symmetry_plane = false; ///< half of the scene is computed, mirrored at y = 0
    bool        is_blade_alone     = false; ///< read by read_blade(): no bird, and nothing is asked of its entries

    BladeParameters blade;
    BirdParameters  bird;
    EosParameters   equation_of_state; ///< of the bird: section Bird/Equation of state
    /// Sections "Bird 2" to "Bird 4"; what they do not give is as in section Bird.
    struct FurtherBird
    {
      BirdParameters bird;
      EosParameters  liquid;
    };
    std::array<FurtherBird, 3> further_birds;

    ContactParameters contact;
    TimeParameters    time;
    OutputParameters  output;
    StudyParameters   study;

    ParameterFile file;

    CaseParameters();
    CaseParameters(const CaseParameters &)            = delete;
    CaseParameters &operator=(const CaseParameters &) = delete;

    /// Reads and checks a case; see ParameterFile::read. Raises InputError.
    void read(const std::string &path, const std::vector<std::string> &overrides = {});

    /// Reads a case for a command that computes its blade alone (statics, modes). The case then has no bird, and the
    /// rules between entries of birds are not checked. The first bird still tells which side is struck, and so the
    /// signs of reports (mesh/orientation.h). Returns why it cannot tell, or an empty text. Raises InputError.
    std::string read_blade(const std::string &path, const std::vector<std::string> &overrides = {});

    /// Those that are enabled, in the order of their numbers.
    std::vector<BirdCase> birds() const;

    /// Where the run writes: `Output/Directory`, or runs/<case name>.
    std::string run_directory() const;

  private:
    void read_entries(const std::string &path, const std::vector<std::string> &overrides);
    void check_further_birds(const std::string &path) const;
    void complete(const std::string &path);
  };

  /// Names of entries, "Section/Entry".
  using EntryNames = std::vector<std::string>;

  /// Entries that name files which the case reads.
  EntryNames file_entries(const CaseParameters &parameters);

  /// The first entry, in the order of declaration, whose values differ ("Bird/Velocity"), other than those named in
  /// `ignored`; empty if none does. Numbers are compared as numbers, files by their contents, all else
  /// as text.
  std::string first_difference(const CaseParameters &a, const CaseParameters &b, const EntryNames &ignored);
} // namespace birdstrike
