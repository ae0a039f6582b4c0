#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace birdstrike
{
  namespace
  {
    namespace Patterns = dealii::Patterns;
    using dealii::Utilities::trim;

    [[noreturn]] void refuse(const std::string &entry, const std::string &piece, const std::string &allowed)
    {
      throw InputError(entry + ": cannot read '" + piece + "'.\nAllowed: " + allowed + ".");
    }

    /// Without surrounding blanks and without empty ones.
    std::vector<std::string> split(const std::string &text, const char separator)
    {
      auto pieces = dealii::Utilities::split_string_list(text, separator);
      std::erase(pieces, "");
      return pieces;
    }

    template <class Value>
    std::vector<Value> parse_values(const std::string &text, const Patterns::PatternBase &pattern,
                                    const std::string &entry, const std::string &allowed)
    {
      std::vector<Value> values;
      for (const std::string &word : parse_words(text))
        {
          if (!pattern.match(word))
            refuse(entry, word, allowed);
          values.push_back(Patterns::Tools::Convert<Value>::to_value(word, pattern));
        }
      return values;
    }
  } // namespace

  std::vector<std::string> parse_words(std::string text)
  {
    std::replace_if(
      text.begin(), text.end(), [](const unsigned char c) { return c == ',' || std::isspace(c); }, ' ');
    return split(text, ' ');
  }

  std::vector<unsigned int> parse_ids(const std::string &text, const std::string &entry)
  {
    return parse_values<unsigned int>(text, Patterns::Integer(0), entry, "boundary ids, e.g. '0, 2'");
  }

  std::vector<double> parse_numbers(const std::string &text, const std::size_t count, const std::string &entry)
  {
    auto numbers = parse_values<double>(text, Patterns::Double(), entry, "a number such as 0.0889 or 1e-3");
    if (numbers.size() != count)
      refuse(entry, text, std::to_string(count) + " numbers separated by blanks");
    return numbers;
  }

  std::vector<std::pair<std::string, std::string>> parse_pairs(const std::string &text, const std::string &entry,
                                                               const char separator)
  {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto &piece : split(text, separator))
      {
        const std::size_t colon = std::min(piece.find(':'), piece.size() - 1);
        pairs.emplace_back(trim(piece.substr(0, colon)), trim(piece.substr(colon + 1)));
        if (pairs.back().first.empty() || pairs.back().second.empty())
          refuse(entry, piece, std::string("'name: value' pairs separated by '") + separator + "'");
      }
    return pairs;
  }

  std::array<bool, 6> parse_components(const std::string &text, const std::string &entry)
  {
    static const std::array<std::string, 6> names{{"ux", "uy", "uz", "rx", "ry", "rz"}};
    std::array<bool, 6>                     held{};
    for (const auto &word : parse_values<std::string>(text, Patterns::Selection("ux|uy|uz|rx|ry|rz|clamped|hinged"),
                                                      entry, "ux uy uz rx ry rz, clamped (all six), hinged (ux uy uz)"))
      for (unsigned int c = 0; c < 6; ++c)
        held[c] = held[c] || word == names[c] || word == "clamped" || (word == "hinged" && c < 3);
    return held;
  }
} // namespace birdstrike
