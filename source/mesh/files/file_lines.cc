#include "mesh/files/file_lines.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/text_file.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace birdstrike
{
  std::string_view trim(std::string_view text)
  {
    const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
  }

  std::string upper(const std::string_view text)
  {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](const unsigned char c) { return std::toupper(c); });
    return result;
  }

  FileLines::FileLines(const std::string &path, const std::string &entry) : path(path), entry(entry)
  {
    std::error_code error;
    auto            text = std::filesystem::is_regular_file(path, error) ? read_text_file(path) : std::nullopt;
    if (!text) // what is no file may never end
      throw InputError(entry + ": cannot open '" + path +
                       "'.\nA path starts at the folder of the parameter file, else at the working directory.");
    whole = std::move(*text);
    left  = whole;
  }

  void FileLines::require_text() const
  {
    if (const std::string what = describe_no_text(whole); !what.empty())
      throw InputError(entry + ": '" + path + "' is no text. It holds " + what + ".");
  }

  bool FileLines::next()
  {
    line = {};
    if (left.empty())
      return false;
    const std::size_t end = std::min(left.find('\n'), left.size());
    line                  = left.substr(0, end);
    left.remove_prefix(std::min(end + 1, left.size()));
    ++n_lines;
    line = line.substr(0, line.find_last_not_of(" \t") + 1);
    return true;
  }

  void FileLines::refuse(const std::string &what, const std::string &remedy) const
  {
    throw InputError(entry + ": '" + path + "', line " + std::to_string(n_lines) + ": " + what + ".\n" + remedy);
  }

  /// Decks write the name of a *PARAMETER for a number, LS-DYNA as '&name', Abaqus as '<name>'.
  void FileLines::refuse_field(const std::string_view field, const char *kind) const
  {
    const std::string text(field);
    if (text.find_first_of("&<") < 2)
      refuse("the parameter '" + text + "' stands for a number; *PARAMETER is not offered",
             "Write the numbers themselves: replace each parameter by its value.");
    refuse("cannot read '" + text + "' as " + kind, "Allowed: numbers in the columns of the format.");
  }

  void FileLines::add_listed(const std::size_t n)
  {
    if (n > largest_list - n_listed)
      refuse("the lists by first and last id and of sets, down to here, have more than " +
               std::to_string(largest_list) + " ids",
             "Leave out the sets that are not needed.");
    n_listed += n;
  }

  std::int64_t FileLines::integer(std::string_view field) const
  {
    field = trim(field);
    if (field.empty())
      return 0;
    std::int64_t value      = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size())
      refuse_field(field, "a whole number");
    return value;
  }

  double FileLines::number(std::string_view field) const
  {
    field = trim(field);
    if (field.empty())
      return 0.;
    std::string text(field.substr(field[0] == '+'));
    std::replace_if(
      text.begin(), text.end(), [](const char c) { return c == 'D' || c == 'd'; }, 'e'); // of Fortran
    double value            = 0.;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      refuse_field(field, "a number");
    return value;
  }

  std::vector<std::string_view> FileLines::split_at_commas() const
  {
    std::vector<std::string_view> fields;
    for (std::string_view rest = line; !rest.empty();)
      {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        fields.push_back(trim(rest.substr(0, comma)));
        rest.remove_prefix(std::min(comma + 1, rest.size()));
      }
    while (!fields.empty() && fields.back().empty())
      fields.pop_back();
    return fields;
  }

  std::vector<std::string_view> FileLines::split_at_blanks() const
  {
    constexpr const char         *blanks = " \t\r";
    std::vector<std::string_view> fields;
    const std::string_view        text = line;
    for (std::size_t begin = text.find_first_not_of(blanks); begin < text.size();)
      {
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        fields.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(blanks, end);
      }
    return fields;
  }
} // namespace birdstrike
