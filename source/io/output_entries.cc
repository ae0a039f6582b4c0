#include <birdstrike/io/output_entries.h>
#include <birdstrike/io/study_parameters.h>

namespace birdstrike
{
  std::vector<std::string> output_entries_and(const std::vector<std::string> &more)
  {
    std::vector<std::string> all{"Case/Description",
                                 "Output/Directory",
                                 "Output/Copy inputs",
                                 "Output/History interval",
                                 "Output/Field interval",
                                 "Output/Console interval",
                                 "Output/Flush interval",
                                 "Output/Checkpoint/Step interval",
                                 "Output/Checkpoint/Time interval",
                                 "Output/Checkpoint/Wall interval",
                                 "Output/Checkpoint/At the end",
                                 "Output/Checkpoint/Keep"};
    for (const auto &further : {study_entries(), more})
      all.insert(all.end(), further.begin(), further.end());
    return all;
  }
} // namespace birdstrike
