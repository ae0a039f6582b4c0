#include "report/comparison/run_record.h"

#include <charconv>
#include <fstream>
#include <stdexcept>

#include "report/histories/history_hdf5.h"

namespace birdstrike
{
  namespace
  {
    /// The fields of a line of history.csv, which quotes nothing.
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> fields;
      for (std::size_t begin = 0; begin <= line.size();)
        {
          const std::size_t end = std::min(line.find(',', begin), line.size());
          fields.push_back(line.substr(begin, end - begin));
          begin = end + 1;
        }
      return fields;
    }

    /// False for what is no number as a whole.
    bool parse(const std::string &text, double &value)
    {
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      return error == std::errc() && end == text.data() + text.size();
    }
  } // namespace

  RunRecord::RunRecord(const std::filesystem::path &folder) : directory(folder)
  {
    std::ifstream in(folder / ".birdstrike");
    std::getline(in, marker);
    read_summary();
    read_history();
  }

  RunRecord RunRecord::unreadable(const std::filesystem::path &folder, const std::string &why)
  {
    RunRecord record;
    record.directory = folder;
    record.marker    = why;
    record.has_files = false;
    return record;
  }

  void RunRecord::read_summary()
  {
    const auto    file = directory / "summary.json";
    std::ifstream in(file);
    if (!in)
      return;
    outcome.json = nlohmann::ordered_json::parse(in, nullptr, false);
    if (!outcome.json.is_object())
      throw std::runtime_error("Cannot read " + file.string() + ": it is no JSON object.");
  }

  void RunRecord::read_history()
  {
    const auto               file = directory / "history.csv";
    std::ifstream            in(file);
    std::vector<std::string> names;
    std::size_t              n_rows = 0;
    for (std::string line; std::getline(in, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        if (in.eof())
          return; // without a line feed: a run that was killed may have left half a line, or half of its last number
        const std::vector<std::string> fields = split(line);
        if (names.empty())
          {
            names = fields;
            continue;
          }
        std::vector<double> row(fields.size());
        bool                is_whole = fields.size() == names.size();
        for (std::size_t i = 0; i < fields.size(); ++i)
          is_whole = parse(fields[i], row[i]) && is_whole;
        ++n_rows;
        if (!is_whole)
          throw std::runtime_error("Cannot read " + file.string() + ": row " + std::to_string(n_rows) +
                                   " of the table has not " + std::to_string(names.size()) + " numbers.");
        for (std::size_t i = 0; i < names.size(); ++i)
          columns[names[i]].push_back(row[i]);
      }
  }

  const std::filesystem::path &RunRecord::folder() const
  {
    return directory;
  }

  bool RunRecord::is_complete() const
  {
    return !outcome.json.is_null();
  }

  const std::string &RunRecord::state() const
  {
    return marker;
  }

  const Summary &RunRecord::summary() const
  {
    return outcome;
  }

  const std::vector<double> &RunRecord::column(const std::string &name) const
  {
    static const std::vector<double> none;
    const auto                       found = columns.find(name);
    return found == columns.end() ? none : found->second;
  }

  std::vector<double> RunRecord::dataset(const std::string &name) const
  {
    return has_files ? read_result(directory / "results.h5", name) : std::vector<double>();
  }
} // namespace birdstrike
