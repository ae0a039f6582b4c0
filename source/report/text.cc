#include <birdstrike/report/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace birdstrike
{
  namespace
  {
    template <class... Arguments>
    std::string print(const char *format, const Arguments... arguments)
    {
      std::array<char, 64> text;
      std::snprintf(text.data(), text.size(), format, arguments...);
      return text.data();
    }
  } // namespace

  std::string format_quantity(const double value, const std::string &unit)
  {
    const std::string blank_unit = unit.empty() || unit == "-" ? "" : " " + unit;
    const bool        takes_prefix =
      unit == "m" || unit == "s" || unit == "Pa" || unit == "J" || unit == "N" || unit == "N m" || unit == "W";
    if (!takes_prefix || value == 0. || !std::isfinite(value))
      return print("%.4g", value) + blank_unit;
    static constexpr std::array<const char *, 8> prefixes{{"n", "u", "m", "", "k", "M", "G", "T"}};
    // Rounded to the printed digits first: 999.96 is 1000, which is 1 k.
    const double rounded  = std::strtod(print("%.3e", value).c_str(), nullptr);
    const int    exponent = std::clamp(static_cast<int>(std::floor(std::log10(std::abs(rounded)) / 3. + 1e-12)), -3, 4);
    const int    used     = unit == "m" ? std::min(exponent, 1) : exponent;
    return print("%.4g ", value / std::pow(1000., used)) + prefixes[used + 3] + unit;
  }

  std::string format_bytes(const double bytes)
  {
    static constexpr std::array<const char *, 5> units{{"B", "KiB", "MiB", "GiB", "TiB"}};
    double                                       value = bytes;
    std::size_t                                  k     = 0;
    for (; value >= 1000. && k + 1 < units.size(); ++k)
      value /= 1024.;
    return print("%.3g ", value) + units[k];
  }

  std::string format_count(const std::uint64_t n)
  {
    const std::string digits = std::to_string(n);
    std::string       text;
    for (std::size_t i = 0; i < digits.size(); ++i)
      {
        if (i > 0 && (digits.size() - i) % 3 == 0)
          text += ' ';
        text += digits[i];
      }
    return text;
  }

  std::string format_duration(const double seconds)
  {
    if (!std::isfinite(seconds) || seconds < 0.)
      return "unknown";
    if (seconds < 59.95)
      return print("%.1f s", seconds);
    const auto whole = static_cast<unsigned long>(std::llround(seconds));
    if (whole < 3600)
      return print("%lu min %02lu s", whole / 60, whole % 60);
    return print("%lu h %02lu min", whole / 3600, whole % 3600 / 60);
  }

  std::string format_share(const double share)
  {
    return print("%.3g %%", 100. * share);
  }

  std::string format_value(const double value, const std::string &unit)
  {
    if (unit == "count")
      return format_count(static_cast<std::uint64_t>(std::llround(value)));
    if (unit == "B")
      return format_bytes(value);
    if (unit == "share")
      return format_share(value);
    return format_quantity(value, unit);
  }

  TextTable::TextTable(std::string title) : title(std::move(title))
  {
  }

  void TextTable::add_heading(const std::string &heading)
  {
    rows.push_back({heading, "", RowKind::heading});
  }

  void TextTable::add(const std::string &key, const std::string &value)
  {
    rows.push_back({key, value, RowKind::plain});
  }

  void TextTable::add(const std::string &key, const double value, const std::string &unit)
  {
    add(key, format_quantity(value, unit));
  }

  void TextTable::add_detail(const std::string &key, const std::string &value)
  {
    rows.push_back({key, value, RowKind::detail});
  }

  std::vector<std::string> TextTable::lines_of(const std::vector<Row> &rows)
  {
    std::size_t width = 0;
    for (const Row &row : rows)
      if (row.kind != RowKind::heading)
        width = std::max(width, row.key.size());
    std::vector<std::string> lines;
    for (const Row &row : rows)
      lines.push_back(row.kind == RowKind::heading
                        ? row.key
                        : "  " + row.key + std::string(width - row.key.size() + 2, ' ') + row.value);
    return lines;
  }

  std::string TextTable::text() const
  {
    std::string text = title.empty() ? "" : title + "\n";
    for (const std::string &line : lines_of(rows))
      text += line + "\n";
    return text;
  }

  std::string TextTable::brief(const std::size_t most) const
  {
    std::vector<Row> kept;
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        std::size_t next = k + 1; // past the details below a heading
        while (next < rows.size() && rows[next].kind == RowKind::detail)
          ++next;
        const bool has_details_alone = next > k + 1 && (next == rows.size() || rows[next].kind == RowKind::heading);
        if (rows[k].kind == RowKind::plain || (rows[k].kind == RowKind::heading && !has_details_alone))
          kept.push_back(rows[k]);
      }
    std::vector<std::string> lines = lines_of(kept);
    if (!title.empty())
      lines.insert(lines.begin(), title);
    if (lines.size() > most)
      {
        const std::size_t n_left_out = lines.size() - most + 1;
        lines.resize(most - 1);
        lines.push_back("  ... and " + std::to_string(n_left_out) + " lines more in log.txt (--verbose shows all)");
      }
    std::string text;
    for (const std::string &line : lines)
      text += line + "\n";
    return text;
  }
} // namespace birdstrike
