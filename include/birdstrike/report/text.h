#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Numbers as a reader wants them: explain report, start-up and closing tables.
namespace birdstrike
{
  /// Four significant digits and an SI prefix: (5.3e-4, "m") -> "0.53 mm" style "530 um"; (0, "J") -> "0 J". Units "-"
  /// and "kg" take no prefix, "Pa" is shown in kPa, MPa, GPa.
  std::string format_quantity(double value, const std::string &unit);

  std::string format_bytes(double bytes);      ///< "1.5 GiB"
  std::string format_count(std::uint64_t n);   ///< "1 234 567"
  std::string format_duration(double seconds); ///< "4.2 s", "3 min 20 s", "2 h 05 min"
  std::string format_share(double share);      ///< 0.0123 -> "1.23 %"

  /// By its unit: "count", "B" and "share" as above, all else as a quantity.
  std::string format_value(double value, const std::string &unit);

  /// Keys and values in two aligned columns under headings.
  class TextTable
  {
  public:
    explicit TextTable(std::string title = "");

    void add_heading(const std::string &heading);
    void add(const std::string &key, const std::string &value);
    void add(const std::string &key, double value, const std::string &unit);
    /// A row that the brief text leaves out.
    void add_detail(const std::string &key, const std::string &value);

    std::string text() const;

    /// Without details and the headings of details alone; of more than `most` lines the last ones left out, and said.
    std::string brief(std::size_t most) const;

  private:
    enum class RowKind
    {
      heading,
      plain,
      detail
    };
    struct Row
    {
      std::string key, value;
      RowKind     kind;
    };
    static std::vector<std::string> lines_of(const std::vector<Row> &rows);

    std::string      title;
    std::vector<Row> rows;
  };

  /// What is told in two lengths: the screen shows the brief one, log.txt keeps the whole.
  struct ToldText
  {
    std::string whole, brief;
  };
} // namespace birdstrike
