#pragma once

#include <birdstrike/io/varied_entry.h>

#include <string>
#include <vector>

namespace birdstrike
{
  /// One combination of values.
  struct StudyPoint
  {
    std::string              name;      ///< "Speed=150, Angle to surface=30"
    std::string              folder;    ///< the same as a folder's name
    std::vector<std::size_t> at;        ///< which value of each entry
    std::vector<std::string> overrides; ///< "Section/Entry=value"
  };

  /// What is varied, and how.
  struct StudyPlan
  {
    std::vector<VariedEntry> entries;
    bool                     are_pairs = false;

    /// Numbers of points along each axis of a table: of the grid, or of the list of pairs.
    std::vector<std::size_t> shape() const;

    /// An entry by the last part of its path, by all of it where another one has the same last part.
    std::string short_name(std::size_t entry) const;
  };

  /// Reads the entries. Throws InputError where there is none, one is there twice or belongs to the study itself
  /// (Output/Directory, Case/Name), pairs have unequal lengths, and for more than most_points points.
  StudyPlan read_study_plan(const std::vector<std::string> &vary, bool are_pairs);

  /// All points, the last entry's values running fastest, each with a folder of its own. Throws InputError where two
  /// pairs are equal.
  std::vector<StudyPoint> make_points(const StudyPlan &plan);

  /// A text as the name of a folder: letters, digits and ".=+-_" stay, others become '-'. One that is long or loses a
  /// letter that may tell it from another, or `is_hashed`, ends in a checksum of the text (FNV-1a).
  std::string make_folder_name(const std::string &text, bool is_hashed = false);
} // namespace birdstrike
