#pragma once

#include <birdstrike/io/report_folder.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A table (CSV) that an earlier report has left: fields as text, without quotes, "" where a row has none.
  class WrittenTable
  {
  public:
    /// Empty if there is no such file.
    explicit WrittenTable(const std::filesystem::path &file);

    const std::vector<std::string> &headings() const;
    std::size_t                     n_rows() const;

    const std::string &field(std::size_t row, std::size_t column) const;
    const std::string &field(std::size_t row, const std::string &heading) const;

  private:
    std::vector<std::string>              names;
    std::vector<std::vector<std::string>> rows;
  };

  /// Throws InputError where a report that is there would be lost: `lost` names what it has and the new one lacks.
  /// `same`: what is allowed in this folder, "the same study again, or one with more points".
  void refuse_loss_of(const std::vector<std::string> &lost, const std::filesystem::path &folder, const ReportKind &kind,
                      const std::string &same);
} // namespace birdstrike
