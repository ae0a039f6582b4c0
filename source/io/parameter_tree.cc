#include "io/parameter_tree.h"

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <regex>
#include <sstream>

namespace birdstrike
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// "A sentence. [kg]" -> {"A sentence.", "kg"}; no unit if the text does not end with one.
    std::pair<std::string, std::string> split_unit(const std::string &text)
    {
      static const std::regex with_unit(R"(^([\s\S]*\S)\s*\[([^\[\]]+)\]\s*$)");
      std::smatch             match;
      if (std::regex_match(text, match, with_unit))
        return {match[1], match[2]};
      return {text, ""};
    }

    std::string describe_interval(const std::string &kind, const std::string &low, const std::string &high)
    {
      const bool has_low  = low != "-MAX_DOUBLE" && low != "-2147483648",
                 has_high = high != "MAX_DOUBLE" && high != "2147483647";
      // Patterns know closed intervals only: a bound next to nothing stands for "not zero".
      if (has_low && kind == "a number" && std::stod(low) > 0. && std::stod(low) <= 1e-12)
        return kind + " above 0" + (has_high ? ", at most " + high : "");
      if (has_low && has_high)
        return kind + " from " + low + " to " + high;
      if (has_low)
        return kind + ", at least " + low;
      return has_high ? kind + ", at most " + high : kind;
    }

    /// deal.II's machine description in words.
    std::string describe_pattern(const std::string &pattern)
    {
      static const std::regex number(R"(^\[(Double|Integer)(?: range)? ?(.*)\.\.\.(.*) \(inclusive\)\]$)");
      static const std::regex list(
        R"(^\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\)(?: separated by <(.*)>)?\]$)");
      static const std::regex bar(R"(\s*\|\s*)"), choice(R"(^\[(?:Multiple)?Selection (.*?) ?\]$)");
      std::smatch             match;
      if (pattern == "[Bool]")
        return "true or false";
      if (pattern == "[Anything]")
        return "any text";
      if (pattern.starts_with("[FileName"))
        return "name of a file";
      if (pattern == "[Double]")
        return "a number";
      if (pattern == "[Integer]")
        return "an integer";
      if (std::regex_match(pattern, match, number))
        return describe_interval(match[1] == "Double" ? "a number" : "an integer", match[2], match[3]);
      if (std::regex_match(pattern, match, choice))
        return "one of " + std::regex_replace(match[1].str(), bar, ", ");
      if (std::regex_match(pattern, match, list))
        {
          if (match[2] == "0" && match[3] == "1")
            return describe_pattern(match[1]) + ", or empty";
          const std::string count = match[2] == match[3] ? match[2].str() : match[2].str() + " to " + match[3].str();
          return count + " items separated by '" + (match[4].length() > 0 ? match[4].str() : ",") + "', each " +
                 describe_pattern(match[1]);
        }
      return dealii::Patterns::pattern_factory(pattern)->description(dealii::Patterns::PatternBase::Text);
    }

    KnownEntry make_entry(const SectionPath &section, const std::string &name, const Json &node)
    {
      const auto [text, unit] = split_unit(node.value("documentation", ""));
      KnownEntry entry;
      entry.section       = section;
      entry.name          = name;
      entry.value         = node.at("value");
      entry.default_value = node.at("default_value");
      entry.text          = text;
      entry.unit          = unit;
      entry.pattern       = node.at("pattern_description");
      entry.range         = describe_pattern(entry.pattern);
      return entry;
    }

    void add_section(const Json &node, const SectionPath &section, std::vector<KnownEntry> &entries,
                     std::vector<SectionPath> &sections)
    {
      for (const auto &[name, child] : node.items())
        if (child.contains("pattern_description") && child["pattern_description"].is_string())
          entries.push_back(make_entry(section, name, child));
        else if (!(child.contains("alias") && child["alias"].is_string()))
          {
            SectionPath inner = section;
            inner.push_back(name);
            sections.push_back(inner);
            add_section(child, inner, entries, sections);
          }
    }

    /// Levenshtein's distance by the row-wise recurrence of Wagner and Fischer (1974).
    std::size_t compute_edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), std::size_t(0));
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const std::size_t above = row[j];
              row[j]   = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
              diagonal = above;
            }
        }
      return row[b.size()];
    }
  } // namespace

  std::string lower_case(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) { return std::tolower(c); });
    return text;
  }

  std::string to_string(const SectionPath &section)
  {
    std::string text;
    for (const std::string &name : section)
      text += (text.empty() ? "" : "/") + name;
    return text.empty() ? "the top level" : text;
  }

  bool KnownEntry::allows(const std::string &candidate) const
  {
    return dealii::Patterns::pattern_factory(pattern)->match(candidate);
  }

  ParameterTree::ParameterTree(const dealii::ParameterHandler &prm)
  {
    std::ostringstream out;
    prm.print_parameters(out, dealii::ParameterHandler::JSON | dealii::ParameterHandler::KeepDeclarationOrder);
    sections.push_back({});
    add_section(Json::parse(out.str()), {}, all, sections);
  }

  void ParameterTree::update_values(const dealii::ParameterHandler &prm)
  {
    for (KnownEntry &entry : all)
      entry.value = prm.get(entry.section, entry.name);
  }

  const std::vector<KnownEntry> &ParameterTree::entries() const &
  {
    return all;
  }

  const KnownEntry *ParameterTree::find(const SectionPath &section, const std::string &name) const
  {
    const auto found = std::find_if(
      all.begin(), all.end(), [&](const KnownEntry &entry) { return entry.name == name && entry.section == section; });
    return found == all.end() ? nullptr : &*found;
  }

  bool ParameterTree::has_section(const SectionPath &section) const
  {
    return std::find(sections.begin(), sections.end(), section) != sections.end();
  }

  std::vector<std::string> ParameterTree::entry_names(const SectionPath &section) const
  {
    std::vector<std::string> names;
    for (const KnownEntry &entry : all)
      if (entry.section == section)
        names.push_back(entry.name);
    return names;
  }

  std::vector<std::string> ParameterTree::subsection_names(const SectionPath &section) const
  {
    std::vector<std::string> names;
    for (const SectionPath &inner : sections)
      if (inner.size() == section.size() + 1 && std::equal(section.begin(), section.end(), inner.begin()))
        names.push_back(inner.back());
    return names;
  }

  std::vector<SectionPath> ParameterTree::sections_with(const std::string &name) const
  {
    std::vector<SectionPath> result;
    for (const KnownEntry &entry : all)
      if (entry.name == name)
        result.push_back(entry.section);
    return result;
  }

  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
  {
    std::string best;
    std::size_t least = (name.size() + 1) / 2 + 1;
    for (const std::string &candidate : candidates)
      if (const std::size_t distance = compute_edit_distance(lower_case(name), lower_case(candidate)); distance < least)
        {
          least = distance;
          best  = candidate;
        }
    return best;
  }
} // namespace birdstrike
