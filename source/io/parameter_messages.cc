#include "io/parameter_messages.h"

#include <algorithm>
#include <map>

namespace birdstrike
{
  namespace
  {
    std::string list_names(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        {
          if (text.size() + name.size() > 100)
            return text + ", ...";
          text += (text.empty() ? "" : ", ") + name;
        }
      return text;
    }

    std::vector<std::string> all_entry_names(const ParameterTree &known)
    {
      std::vector<std::string> names;
      for (const KnownEntry &entry : known.entries())
        names.push_back(entry.name);
      return names;
    }

    std::string list_sections(const std::vector<SectionPath> &sections)
    {
      std::vector<std::string> names;
      for (const SectionPath &section : sections)
        names.push_back(quote(to_string(section)));
      return list_names(names);
    }

    /// Names, sorted, of files with one of these extensions.
    std::vector<std::string> files_in(const std::filesystem::path              &folder,
                                      const std::vector<std::filesystem::path> &extensions)
    {
      std::error_code          error;
      std::vector<std::string> names;
      for (const auto &file : std::filesystem::directory_iterator(folder, error))
        if (std::ranges::find(extensions, file.path().extension()) != extensions.end())
          names.push_back(file.path().filename().string());
      std::ranges::sort(names);
      return names;
    }

    std::string describe_entry(const KnownEntry &entry)
    {
      return entry.range + (entry.unit.empty() ? "" : " [" + entry.unit + "]") + "; default " +
             quote(entry.default_value);
    }

    /// By letters, else the first whose name begins with the word.
    std::string nearest_here(const std::string &name, const std::vector<std::string> &names)
    {
      const std::string nearest = nearest_name(name, names);
      const auto        found =
        std::ranges::find_if(names, [&](const std::string &each) { return each.starts_with(name + " "); });
      return !nearest.empty() || found == names.end() ? nearest : *found;
    }

    /// Why an entry that files of earlier versions set is gone; empty: there has been none.
    std::string reason_of_removal(const SectionPath &section, const std::string &name)
    {
      static const std::map<std::string, std::string> of_birds{
        {"Tension cut-off",
         "The liquid carries no tension: stretched particles of SPH clump and end the run (Swegle et al. 1995)."}};
      const auto found = of_birds.find(name);
      return found != of_birds.end() && section.size() == 1 && section[0].starts_with("Bird") ? found->second : "";
    }
  } // namespace

  std::string message(const std::initializer_list<std::string> lines)
  {
    std::string text;
    for (const std::string &line : lines)
      if (!line.empty())
        text += (text.empty() ? "" : "\n") + line;
    return text;
  }

  std::string quote(const std::string &text)
  {
    return "'" + (text.size() > 80 ? text.substr(0, 77) + "..." : text) + "'";
  }

  std::string describe_section(const SectionPath &section)
  {
    return section.empty() ? "top level" : "section " + quote(to_string(section));
  }

  std::string describe_unknown_entry(const SourceLine &where, const SectionPath &section, const std::string &name,
                                     const ParameterTree &known)
  {
    if (const std::string reason = reason_of_removal(section, name); !reason.empty())
      return message(
        {where.text() + ", " + describe_section(section) + ": there is no entry " + quote(name) + " any more.",
         "  " + reason, "  Action: remove the line."});
    const std::vector<SectionPath> elsewhere = known.sections_with(name);
    const std::string              here      = nearest_here(name, known.entry_names(section));
    std::string                    advice;
    if (!elsewhere.empty())
      advice = "  " + quote(name) + " is an entry of section " + list_sections(elsewhere) + ": set it there.";
    else if (!here.empty())
      advice = "  Nearest name here: '" + here + "' (" + describe_entry(*known.find(section, here)) + ").";
    else if (const std::string anywhere = nearest_name(name, all_entry_names(known)); !anywhere.empty())
      advice = "  Nearest name: '" + anywhere + "' in section " + list_sections(known.sections_with(anywhere)) + ".";
    const std::string names = list_names(known.entry_names(section));
    return message({where.text() + ", " + describe_section(section) + ": there is no entry " + quote(name) + " here.",
                    advice, "  Entries here: " + (names.empty() ? "none" : names),
                    "  Action: correct the name; 'birdstrike parameters' prints every entry."});
  }

  std::string describe_unknown_section(const SourceLine &where, const SectionPath &section,
                                       const unsigned int opened_at, const std::string &name,
                                       const ParameterTree &known)
  {
    std::string forgotten_end;
    SectionPath outer = section;
    while (!outer.empty() && forgotten_end.empty())
      {
        outer.pop_back();
        SectionPath candidate = outer;
        candidate.push_back(name);
        if (known.has_section(candidate) && opened_at > 0)
          forgotten_end = "  " + quote(name) + " is a section of " + to_string(outer) + ": is 'end' missing for '" +
                          section.back() + "', opened in line " + std::to_string(opened_at) + "?";
      }
    const std::vector<std::string> here    = known.subsection_names(section);
    const std::string              nearest = nearest_name(name, here);
    const std::string              names   = list_names(here);
    return message({where.text() + ": there is no subsection " + quote(name) + " in " +
                      (section.empty() ? to_string(section) : quote(to_string(section))) + ".",
                    forgotten_end, nearest.empty() ? "" : "  Nearest name here: " + quote(nearest) + ".",
                    "  Subsections here: " + (names.empty() ? "none" : names),
                    "  Action: correct the name; 'birdstrike parameters' prints every section."});
  }

  std::string describe_bad_value(const SourceLine &where, const KnownEntry &entry, const std::string &value)
  {
    std::string nearest;
    if (entry.range.rfind("one of ", 0) == 0)
      {
        std::vector<std::string> choices;
        for (std::size_t begin = 7; begin < entry.range.size();)
          {
            const std::size_t end = std::min(entry.range.find(", ", begin), entry.range.size());
            choices.push_back(entry.range.substr(begin, end - begin));
            begin = end + 2;
          }
        nearest = nearest_name(value, choices);
      }
    return message(
      {where.text() + ", " + describe_section(entry.section) + ": '" + entry.name + "' cannot be " + quote(value) + ".",
       "  Allowed: " + describe_entry(entry) + ".", nearest.empty() ? "" : "  Nearest choice: '" + nearest + "'.",
       "  Meaning: " + entry.text});
  }

  std::string describe_bad_statement(const SourceLine &where, const std::string &statement)
  {
    return message({where.text() + ": this is no statement of a parameter file.", "  Read: " + quote(statement),
                    "  Allowed: subsection NAME | end | set ENTRY = VALUE | include FILE | # comment"});
  }

  std::string describe_missing_file(const std::filesystem::path &path, const SourceLine &includer)
  {
    namespace fs = std::filesystem;
    std::error_code   error;
    const std::string of_includer = includer.line > 0 ? "  Included by " + includer.text() + "." : "";
    if (fs::is_directory(path, error))
      {
        if (fs::exists(path / "parameters.prm", error))
          return message({"Cannot read the parameter file '" + path.string() + "': it is a folder.", of_includer,
                          "  Action: give '" + (path / "parameters.prm").string() +
                            "', the case that was run there, with all changes by --set."});
        const std::string there = list_names(files_in(path, {".prm"}));
        return message({"Cannot read the parameter file '" + path.string() + "': it is a folder.", of_includer,
                        there.empty() ? "" : "  Parameter files in it: " + there,
                        "  Action: give " + std::string(there.empty() ? "a parameter file" : "one of them") + ", '" +
                          (path / (there.empty() ? "CASE.prm" : files_in(path, {".prm"}).front())).string() + "'."});
      }
    const fs::path    folder  = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string nearest = nearest_name(path.filename().string(), files_in(folder, {path.extension(), ".prm"}));
    const std::string reason  = fs::exists(path, error) ? "it cannot be opened" : "there is no such file";
    return message({"Cannot read the parameter file '" + path.string() + "': " + reason + ".", of_includer,
                    nearest.empty() ? "" : "  Nearest name there: '" + (folder / nearest).string() + "'.",
                    "  Action: correct the path."});
  }
} // namespace birdstrike
