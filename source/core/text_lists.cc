#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    std::string trimmed(const std::string &text)
    {
      const auto first = text.find_first_not_of(" \t\n");
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
    }

    [[noreturn]] void refuse(const std::string &entry, const std::string &piece, const std::string &allowed)
    {
      throw InputError("Blade/" + entry + ": cannot read '" + piece + "'.\nAllowed: " + allowed + ".");
    }

    /// Words between blanks or commas.
    std::vector<std::string> words(const std::string &text)
    {
      std::vector<std::string> found;
      std::string              word;
      for (const char c : text + " ")
        if (std::isspace(static_cast<unsigned char>(c)) || c == ',')
          {
            if (!word.empty())
              found.push_back(word);
            word.clear();
          }
        else
          word += c;
      return found;
    }

    double parse_number(const std::string &word, const std::string &entry)
    {
      std::size_t used  = 0;
      double      value = 0.;
      try
        {
          value = std::stod(word, &used);
        }
      catch (const std::logic_error &)
        {
        }
      if (used != word.size() || !std::isfinite(value))
        refuse(entry, word, "a number such as 0.0889 or 1e-3");
      return value;
    }
  } // namespace

  std::vector<std::string> split(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces;
    std::size_t              begin = 0;
    while (begin <= text.size())
      {
        const std::size_t end   = std::min(text.find(separator, begin), text.size());
        const std::string piece = trimmed(text.substr(begin, end - begin));
        if (!piece.empty())
          pieces.push_back(piece);
        begin = end + 1;
      }
    return pieces;
  }

  std::vector<unsigned int> parse_ids(const std::string &text, const std::string &entry)
  {
    std::vector<unsigned int> ids;
    for (const auto &word : words(text))
      {
        if (word.find_first_not_of("0123456789") != std::string::npos || word.size() > 9)
          refuse(entry, word, "boundary ids, e.g. '0, 2'");
        ids.push_back(std::stoul(word));
      }
    return ids;
  }

  std::vector<double> parse_numbers(const std::string &text, const std::size_t count, const std::string &entry)
  {
    const auto found = words(text);
    if (found.size() != count)
      refuse(entry, text, std::to_string(count) + " numbers separated by blanks");
    std::vector<double> numbers;
    for (const auto &word : found)
      numbers.push_back(parse_number(word, entry));
    return numbers;
  }

  std::vector<std::pair<std::string, std::string>> parse_pairs(const std::string &text, const std::string &entry,
                                                               const char separator)
  {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto &piece : split(text, separator))
      {
        const std::size_t colon = piece.find(':');
        if (colon == std::string::npos || trimmed(piece.substr(0, colon)).empty() ||
            trimmed(piece.substr(colon + 1)).empty())
          refuse(entry, piece, std::string("'what: value' pairs separated by '") + separator + "'");
        pairs.emplace_back(trimmed(piece.substr(0, colon)), trimmed(piece.substr(colon + 1)));
      }
    return pairs;
  }

  std::array<bool, 6> parse_components(const std::string &text, const std::string &entry)
  {
    static const std::array<std::string, 6> names{{"ux", "uy", "uz", "rx", "ry", "rz"}};
    std::array<bool, 6>                     held{};
    for (const auto &word : words(text))
      {
        bool known = word == "clamped" || word == "hinged";
        for (unsigned int c = 0; c < 6; ++c)
          if (word == names[c] || word == "clamped" || (word == "hinged" && c < 3))
            held[c] = known = true;
        if (!known)
          refuse(entry, word, "ux uy uz rx ry rz, clamped (all six), hinged (ux uy uz)");
      }
    return held;
  }
} // namespace birdstrike
