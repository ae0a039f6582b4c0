#include "mesh/files/ls_dyna/cards.h"

#include <algorithm>

namespace birdstrike
{
  bool LsDynaCards::next()
  {
    while (lines.next())
      if (is_keyword())
        {
          parse_keyword();
          return name != "END";
        }
      else if (!lines.text().starts_with('$'))
        return true;
    return false;
  }

  void LsDynaCards::parse_keyword()
  {
    const auto widths_of = [](const char sign) {
      return sign == '+' ? Widths{20, 20, 20} : sign == '%' ? Widths{10, 10, 16} : Widths{};
    };
    keyword_line            = lines.line_number();
    const std::string text  = upper(lines.text().substr(1));
    name                    = text.substr(0, text.find_first_of(" \t(+%-"));
    const std::string after = text.substr(name.size(), text.find('(') - name.size());
    const auto        sign  = after.find_first_of("+%-");
    words.clear();
    for (std::string_view rest = name; words.empty() || !rest.empty();)
      {
        const std::size_t end = std::min(rest.find('_'), rest.size());
        words.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
    if (name == "KEYWORD")
      {
        const bool is_long = after.find("LONG=Y") != std::string::npos,
                   is_i10  = after.find("I10=Y") != std::string::npos;
        standard           = widths_of(is_long ? '+' : is_i10 ? '%' : '-');
      }
    widths = sign == std::string::npos ? standard : widths_of(after[sign]);
  }

  double LsDynaCards::real_at(const std::size_t number, const std::size_t first, const std::size_t width) const
  {
    const std::string_view text = trim(field(number, first, width));
    const std::size_t      sign = text.find_last_of("+-");
    if (sign == text.npos || sign == 0 || text.find_first_not_of("0123456789.+-") != text.npos)
      return lines.number(text);
    return lines.number(std::string(text.substr(0, sign)) + 'e' + std::string(text.substr(sign)));
  }

  std::string LsDynaCards::word(const std::size_t k) const
  {
    return upper(trim(field(k, k * widths.integer, widths.integer)));
  }

  bool LsDynaCards::has_word(const char *word) const
  {
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  std::string_view LsDynaCards::field(const std::size_t number, const std::size_t first, const std::size_t width) const
  {
    const std::string_view text = lines.text();
    if (text.find(',') == std::string_view::npos)
      return first < text.size() ? text.substr(first, width) : std::string_view();
    const auto fields = lines.split_at_commas();
    return number < fields.size() ? fields[number] : std::string_view();
  }
} // namespace birdstrike
