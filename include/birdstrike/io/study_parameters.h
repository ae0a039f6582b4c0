#pragma once

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// What `birdstrike study` varies. Section `Study`: a run by itself does not
  /// look at it, the study reads and checks it.
  struct StudyParameters
  {
    std::array<std::string, 4> vary; ///< "Section/Entry = VALUES", as varied_entry.h reads them; empty: none
    bool                       are_pairs = false; ///< values go together one by one, instead of each with each

    void declare(dealii::ParameterHandler &prm);

    std::vector<std::string> given() const; ///< those that are not empty
  };

  /// Names of its entries: two cases that differ in them alone are one.
  std::vector<std::string> study_entries();
} // namespace birdstrike
