#include "io/parameter_tree.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/entry_search.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Found = std::vector<const KnownEntry *>;

    const std::string no_unit = "-";

    std::string path_of(const KnownEntry &entry)
    {
      return (entry.section.empty() ? "" : to_string(entry.section) + "/") + entry.name;
    }

    template <class Accept>
    Found select(const ParameterTree &tree, const Accept &accept)
    {
      Found found;
      for (const KnownEntry &entry : tree.entries())
        if (accept(entry))
          found.push_back(&entry);
      return found;
    }

    Found find(const ParameterTree &tree, const std::string &asked)
    {
      const std::string word    = lower_case(asked.substr(0, asked.find_last_not_of('/') + 1));
      Found             by_path = select(tree, [&](const KnownEntry &entry) {
        const std::string path = lower_case(path_of(entry));
        return path == word || path.starts_with(word + "/");
      });
      if (!by_path.empty())
        return by_path;
      const auto has_word = [&](const std::string &text) { return lower_case(text).find(word) != std::string::npos; };
      Found      by_name  = select(tree, [&](const KnownEntry &entry) { return has_word(path_of(entry)); });
      if (!by_name.empty())
        return by_name;
      return select(tree, [&](const KnownEntry &entry) { return has_word(entry.text); });
    }

    /// "Bird 3" is "Bird", with its number taken away.
    std::string without_number(const std::string &name)
    {
      const std::size_t blank       = name.rfind(' ');
      const bool        is_numbered = blank != std::string::npos && blank + 1 < name.size() &&
                               std::all_of(name.begin() + static_cast<std::ptrdiff_t>(blank) + 1, name.end(),
                                           [](const unsigned char letter) { return std::isdigit(letter); });
      return is_numbered ? name.substr(0, blank) : name;
    }

    std::string describe(const KnownEntry &entry)
    {
      std::string text = path_of(entry) + "\n  " + entry.text + "\n  " + entry.range;
      if (!entry.unit.empty() && entry.unit != no_unit)
        text += "; unit " + entry.unit;
      return text + "; default " + (entry.default_value.empty() ? "empty" : entry.default_value) + "\n";
    }
  } // namespace

  std::string describe_entries(const ParameterTree &tree, const std::string &word)
  {
    const Found found = find(tree, word);
    if (found.empty())
      {
        std::vector<std::string> names;
        for (const KnownEntry &entry : tree.entries())
          for (const std::string &name : {entry.name, entry.section.empty() ? entry.name : entry.section.back()})
            names.push_back(name);
        const std::string nearest = nearest_name(word, names);
        throw InputError("No entry has '" + word + "' in its section, name or text." +
                         (nearest.empty() ? "" : "\nNearest name: '" + nearest + "'.") +
                         "\nbirdstrike parameters prints all entries.");
      }
    std::map<std::string, std::set<std::string>> repeated; // sections, by the one that is shown
    std::map<std::string, std::string>           shown;    // section, by entry without numbers
    std::string                                  text;
    for (const KnownEntry *entry : found)
      {
        std::string plain;
        for (const std::string &name : entry->section)
          plain += (plain.empty() ? "" : "/") + without_number(name);
        const std::string section = to_string(entry->section);
        if (const auto [first, is_new] = shown.emplace(plain + "/" + entry->name, section); !is_new)
          repeated[first->second].insert(section);
        else
          text += describe(*entry);
      }
    for (const auto &[section, others] : repeated)
      for (const std::string &other : others)
        if (other != section)
          text += fmt::format("Section {} has the same entries as {}.\n", other, section);
    return text;
  }
} // namespace birdstrike
