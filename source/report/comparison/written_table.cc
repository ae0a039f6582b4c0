#include "report/comparison/written_table.h"
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace birdstrike
{
  namespace
  {
    /// Of one line, as csv_field writes them (RFC 4180).
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> fields(1);
      bool                     is_quoted = false;
      for (std::size_t k = 0; k < line.size(); ++k)
        {
          const bool is_quote = line[k] == '"';
          if (is_quoted && is_quote && k + 1 < line.size() && line[k + 1] == '"')
            fields.back() += line[++k];
          else if (is_quote)
            is_quoted = !is_quoted;
          else if (line[k] == ',' && !is_quoted)
            fields.emplace_back();
          else
            fields.back() += line[k];
        }
      return fields;
    }
  } // namespace

  WrittenTable::WrittenTable(const std::filesystem::path &file)
  {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      if (names.empty())
        names = split(line);
      else
        rows.push_back(split(line));
  }

  const std::vector<std::string> &WrittenTable::headings() const
  {
    return names;
  }

  std::size_t WrittenTable::n_rows() const
  {
    return rows.size();
  }

  const std::string &WrittenTable::field(const std::size_t row, const std::size_t column) const
  {
    static const std::string none;
    return column < rows[row].size() ? rows[row][column] : none;
  }

  const std::string &WrittenTable::field(const std::size_t row, const std::string &heading) const
  {
    return field(row, static_cast<std::size_t>(std::ranges::find(names, heading) - names.begin()));
  }

  void refuse_loss_of(const std::vector<std::string> &lost, const std::filesystem::path &folder, const ReportKind &kind,
                      const std::string &same)
  {
    if (lost.empty())
      return;
    throw InputError(fmt::format("The folder '{}' holds the tables of another {}, with '{}'{}.\n  Allowed there: {}.\n"
                                 "  Action: --output DIR for another folder, or --force to replace these tables.",
                                 folder.string(), kind.name, lost[0],
                                 lost.size() > 1 ? fmt::format(" and {} more", lost.size() - 1) : "", same));
  }
} // namespace birdstrike
