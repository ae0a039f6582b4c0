#include "report/comparison/comparison_figures.h"
#include "report/comparison/comparison_table.h"

#include "fuzz_input.h"

#include <stdexcept>

/// What a run left, set beside itself: marker, summary.json and history.csv, apart by lines "--".
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  using namespace birdstrike;
  static const fuzz::Folder folder;
  std::string_view          rest = fuzz::text_of(data, size);
  for (const char *name : {".birdstrike", "summary.json", "history.csv"})
    {
      const std::size_t end = std::min(rest.find("--\n"), rest.size());
      folder.write(name, rest.substr(0, end));
      rest.remove_prefix(std::min(end + 3, rest.size()));
    }
  try
    {
      const std::vector<ComparedRun> runs{{"one", RunRecord(folder.path)}, {"other", RunRecord(folder.path)}};
      const ComparisonTable          table(runs);
      table.as_text();
      table.as_markdown();
      table.as_csv();
      for (const Figure &figure : make_comparison_figures(runs))
        data_of(figure);
    }
  catch (const std::runtime_error &) // documented: a file that is there and cannot be read
    {
    }
  return 0;
}
