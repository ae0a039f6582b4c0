#include "io/parameter_scan.h"
#include "io/parameter_tree.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace birdstrike
{
  namespace
  {
    /// Appends text as comment lines of at most 100 columns.
    void add_comment(std::string &out, const std::string &indent, const std::string &text)
    {
      std::istringstream words(text);
      std::string        word, line = indent + "#";
      while (words >> word)
        {
          if (line.size() + word.size() + 1 > 100)
            {
              out += line + "\n";
              line = indent + "#";
            }
          line += " " + word;
        }
      out += line + "\n";
    }

    bool is_true(const std::string &value)
    {
      bool truth = false;
      std::istringstream(value) >> std::boolalpha >> truth;
      return truth;
    }

    /// By "Section/Entry": sentences beside entries, and values in the place of theirs.
    struct Notes
    {
      const std::map<std::string, std::string> &sentences, &values;
    };

    void add_prm_section(std::string &out, const ParameterTree &tree, const Notes &notes, const SectionPath &section,
                         const std::set<std::string> &left_out)
    {
      const std::string indent(2 * section.size(), ' ');
      for (const KnownEntry &entry : tree.entries())
        if (entry.section == section)
          {
            add_comment(out, indent, entry.text + (entry.unit.empty() ? "" : " [" + entry.unit + "]"));
            add_comment(out, indent,
                        "Range: " + entry.range +
                          ". Default: " + (entry.default_value.empty() ? "empty" : entry.default_value) + ".");
            const std::string name = to_string(section) + "/" + entry.name;
            if (const auto note = notes.sentences.find(name); note != notes.sentences.end())
              add_comment(out, indent, note->second);
            const auto         other = notes.values.find(name);
            const std::string &value = other == notes.values.end() ? entry.value : other->second;
            out += indent + "set " + entry.name + " =" + (value.empty() ? "" : " ") + value + "\n\n";
          }
      for (const std::string &name : tree.subsection_names(section))
        {
          if (section.empty() && left_out.contains(name))
            continue;
          SectionPath inner = section;
          inner.push_back(name);
          out += indent + "subsection " + name + "\n";
          add_prm_section(out, tree, notes, inner, left_out);
          if (out.size() > 2 && out.compare(out.size() - 2, 2, "\n\n") == 0)
            out.pop_back();
          out += indent + "end\n\n";
        }
    }
  } // namespace

  void ParameterGroup::declare_in_section(dealii::ParameterHandler &prm, const std::string &section,
                                          const std::function<void(dealii::ParameterHandler &)> &declare)
  {
    if (!section.empty())
      prm.enter_subsection(section);
    declare(prm);
    if (!section.empty())
      prm.leave_subsection();
  }

  ParameterFile::ParameterFile(const std::vector<ParameterGroup> &groups)
    : groups(groups), prm(std::make_unique<dealii::ParameterHandler>())
  {
    for (const ParameterGroup &group : groups)
      group.declare(*prm);
    known = std::make_unique<ParameterTree>(*prm);
  }

  ParameterFile::~ParameterFile() = default;

  void ParameterFile::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    ScannedParameters scanned;
    scan_parameter_file(path, *known, scanned);
    for (const std::string &override_text : overrides)
      scan_override(override_text, *known, scanned);
    original_text = scanned.original;
    given         = scanned.given;
    included      = scanned.included;
    files         = scanned.files;
    warnings      = scanned.warnings;
    parse(scanned.text);
    for (const Inheritance &rule : inheritances)
      apply(rule);
    for (const ParameterGroup &group : groups)
      try
        {
          group.check();
        }
      catch (const InputError &error)
        {
          throw InputError(path + ": " + error.what());
        }
  }

  void ParameterFile::parse(const std::string &text)
  {
    prm->parse_input_from_string(text);
    known->update_values(*prm);
  }

  void ParameterFile::inherit(const Inheritance &rule)
  {
    inheritances.push_back(rule);
  }

  void ParameterFile::apply(const Inheritance &rule)
  {
    if (!is_true(known->find({rule.section}, rule.when)->value))
      return;
    std::set<std::string> not_inherited(rule.own.begin(), rule.own.end());
    not_inherited.insert(rule.when);
    const auto is_given_here = [&](const std::string &name) { return is_given(rule.section + "/" + name); };
    for (const Inheritance::Alternative &each : rule.alternatives)
      if (std::ranges::any_of(each.given, is_given_here))
        not_inherited.insert(each.replaced.begin(), each.replaced.end());
    std::vector<std::string> inherited;
    for (const KnownEntry &entry : known->entries())
      if (!entry.section.empty() && entry.section.front() == rule.from)
        {
          const std::string there = to_string(entry.section) + "/" + entry.name;
          const std::string name  = there.substr(rule.from.size() + 1);
          if (is_given_here(name) || not_inherited.count(name) > 0)
            continue;
          inherited.push_back(rule.section + "/" + name + "=" + entry.value);
          if (is_given(there))
            given[rule.section + "/" + name] = given[there];
        }
    set(inherited);
  }

  void ParameterFile::set(const std::vector<std::string> &overrides)
  {
    ScannedParameters scanned;
    for (const std::string &override_text : overrides)
      scan_override(override_text, *known, scanned);
    parse(scanned.text);
  }

  bool ParameterFile::is_given(const std::string &entry) const
  {
    const auto found = given.find(entry);
    return found != given.end() && !found->second.is_default;
  }

  bool ParameterFile::says_anything() const
  {
    return !included.empty() ||
           std::ranges::any_of(given, [](const auto &each) { return !each.second.source.empty(); });
  }

  std::string ParameterFile::given_value(const std::string &entry) const
  {
    return is_given(entry) ? given.at(entry).value : "";
  }

  std::vector<std::string> ParameterFile::set_before(const std::string &section, const std::string &name) const
  {
    const auto               change = given.find(section + "/" + name);
    const auto               entry  = std::ranges::find_if(known->entries(), [&](const KnownEntry &each) {
      return to_string(each.section) == section && each.name == name;
    });
    std::vector<std::string> names;
    if (change == given.end() || entry == known->entries().end() ||
        change->second.value == change->second.before.value_or(entry->default_value))
      return names;
    for (const KnownEntry &each : known->entries())
      if (to_string(each.section) == section)
        if (const auto found = given.find(section + "/" + each.name);
            found != given.end() && found->second.value != each.default_value &&
            found->second.source != change->second.source && found->second.order < change->second.order)
          names.push_back(each.name);
    return names;
  }

  bool ParameterFile::is_changed(const std::string &section) const
  {
    return std::ranges::any_of(known->entries(), [&](const KnownEntry &entry) {
      return !entry.section.empty() && entry.section.front() == section && entry.value != entry.default_value;
    });
  }

  const std::vector<std::string> &ParameterFile::included_files() const
  {
    return included;
  }

  const std::vector<ScannedFile> &ParameterFile::scanned_files() const
  {
    return files;
  }

  const std::vector<std::string> &ParameterFile::file_warnings() const
  {
    return warnings;
  }

  void ParameterFile::annotate(const std::string &entry, const std::string &sentence)
  {
    notes[entry] = sentence;
  }

  const std::string &ParameterFile::original() const
  {
    return original_text;
  }

  std::string ParameterFile::as_prm(const bool                                with_unused,
                                    const std::map<std::string, std::string> &other_values) const
  {
    std::string           text;
    std::set<std::string> left_out;
    for (const Inheritance &rule : inheritances)
      if (!with_unused && !is_changed(rule.section))
        left_out.insert(rule.section);
    add_prm_section(text, *known, {notes, other_values}, {}, left_out);
    while (text.size() > 1 && text.compare(text.size() - 2, 2, "\n\n") == 0)
      text.pop_back();
    return text;
  }

  std::string ParameterFile::as_json() const
  {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const KnownEntry &entry : known->entries())
      {
        nlohmann::ordered_json *node = &json;
        for (const std::string &name : entry.section)
          node = &(*node)[name];
        (*node)[entry.name] = {{"text", entry.text},
                               {"unit", entry.unit},
                               {"range", entry.range},
                               {"default", entry.default_value},
                               {"value", entry.value}};
      }
    return json.dump(2) + "\n";
  }

  const ParameterTree &ParameterFile::tree() const
  {
    return *known;
  }
} // namespace birdstrike
