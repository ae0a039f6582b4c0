#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// Sentences about a mesh file that a user must hear: what it says of the blade, and is passed over. Each names the
  /// line.
  struct FileNotes
  {
    std::vector<std::string> always;
    std::vector<std::string> of_plies; ///< that matter to laminates alone
  };
} // namespace birdstrike
