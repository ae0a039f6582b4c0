#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike
{
  std::string_view trim(std::string_view text); ///< without surrounding blanks
  std::string      upper(std::string_view text);

  /// The lines of a text file (decoded: core/text/text_file.h), and what stands in them; complaints name entry, file
  /// and line.
  class FileLines
  {
  public:
    /// Throws InputError if it cannot be opened. `entry`: that names the file.
    explicit FileLines(const std::string &path, const std::string &entry = "Blade/Mesh/File");
    FileLines(const FileLines &) = delete; // `line` looks into `whole`

    void require_text() const; ///< throws InputError, saying what it is, for an archive or a workbook

    bool next(); ///< takes the next line, false at the end

    std::string_view text() const ///< of the line, without blanks at its end; stays valid
    {
      return line;
    }
    std::size_t line_number() const ///< 1 the first
    {
      return n_lines;
    }
    [[noreturn]] void refuse(const std::string &what, const std::string &remedy) const;

    /// Counts ids that the file does not write down one by one: refuses more than `largest_list` of them all, for a few
    /// lines could ask for any memory.
    void                         add_listed(std::size_t n);
    static constexpr std::size_t largest_list = 10'000'000;

    /// A field of the line as a number, finite; blank: 0.
    std::int64_t integer(std::string_view field) const;
    double       number(std::string_view field) const;

    std::vector<std::string_view> split_at_commas() const; ///< trimmed, without empty ones at the end
    std::vector<std::string_view> split_at_blanks() const;

  private:
    [[noreturn]] void refuse_field(std::string_view field, const char *kind) const;

    std::string      path, entry, whole;
    std::string_view line, left; ///< left: what has not been read
    std::size_t      n_lines = 0, n_listed = 0;
  };
} // namespace birdstrike
