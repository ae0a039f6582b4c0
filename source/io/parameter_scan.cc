#include "io/parameter_scan.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "io/inputs/file_entries.h"
#include "io/parameter_messages.h"
#include "io/statement_reader.h"
#include "io/typed_numbers.h"

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Outer blanks removed, inner runs of blanks made one: deal.II's own reading of a line.
    std::string normalise(const std::string &text)
    {
      std::istringstream in(text);
      std::string        word, result;
      while (in >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    /// What follows the first word, with the blanks within it: names of files keep theirs.
    std::string behind_first_word(const std::string &text)
    {
      constexpr const char *blanks = " \t\n\v\f\r";
      const std::size_t     end    = text.find_first_of(blanks, text.find_first_not_of(blanks));
      const std::size_t     begin = text.find_first_not_of(blanks, end), last = text.find_last_not_of(blanks);
      return text.substr(begin, last + 1 - begin);
    }

    /// Truth as people write it, in deal.II's spelling.
    std::string normalise_value(const std::string &value, const KnownEntry &entry)
    {
      if (entry.pattern != "[Bool]")
        return value;
      if (value == "on" || value == "yes")
        return "true";
      return value == "off" || value == "no" ? "false" : value;
    }

    /// One `set Entry = value`.
    struct Assignment : ScannedValue
    {
      unsigned int line;

      void add_to(ScannedParameters &result, const std::string &source) const
      {
        result.text += "set " + name + " = " + value + "\n";
        const std::string          entry = (section.empty() ? "" : to_string(section) + "/") + name;
        std::optional<std::string> before;
        if (const auto earlier = result.given.find(entry); earlier != result.given.end())
          before = earlier->second.source == source ? earlier->second.before : earlier->second.value;
        result.given[entry] = {source, result.n_read, value, before, is_default};
        ++result.n_read;
      }
    };

    Assignment read_assignment(const SectionPath &section, const std::string &statement, const SourceLine &where,
                               const ParameterTree &known)
    {
      const std::size_t equals = statement.find('=');
      if (equals == std::string::npos)
        throw InputError(message({where.text() + ", " + describe_section(section) + ": '=' is missing.",
                                  "  Read: " + quote(statement), "  Allowed: set ENTRY = VALUE"}));
      const std::string name  = normalise(statement.substr(0, equals));
      const KnownEntry *entry = known.find(section, name);
      if (entry == nullptr)
        throw InputError(describe_unknown_entry(where, section, name, known));
      const std::string typed = normalise(statement.substr(equals + 1));
      if (typed == "default")
        return {{section, name, entry->default_value, true}, where.line};
      const std::string value =
        read_typed_numbers(normalise_value(typed, *entry), *entry, where.text() + ", " + describe_section(section));
      if (!entry->allows(value))
        throw InputError(describe_bad_value(where, *entry, typed == value ? value : typed + " = " + value));
      return {{section, name, value, false}, where.line};
    }

    /// One file: the state between its lines.
    class FileScanner
    {
    public:
      FileScanner(const fs::path &path, const SectionPath &start, const ParameterTree &known, const unsigned int depth,
                  ScannedParameters &result)
        : path(path), known(known), depth(depth), start(start), section(start), result(result)
      {
      }

      void scan()
      {
        file = result.files.size();
        result.files.push_back({path.string(), read_parameter_text(path, includer)});
        const std::string whole_text = result.files[file].text;
        if (depth == 0)
          {
            result.original = whole_text;
            result.folder   = folder().string();
          }
        const bool        has_mark = whole_text.starts_with("\xEF\xBB\xBF"); // by which some editors begin UTF-8
        const std::string text     = whole_text.substr(has_mark ? 3 : 0);
        StatementReader   reader(text);
        for (std::string statement; reader.next(statement);)
          {
            where             = {path.string(), reader.line};
            const auto n_mark = has_mark ? std::size_t(3) : std::size_t(0);
            begin             = reader.begin + n_mark;
            end               = reader.end + n_mark;
            read_statement(statement);
          }
        if (!opened_at.empty())
          throw InputError(message({path.string() + ": subsection '" + section.back() + "', opened in line " +
                                      std::to_string(opened_at.back()) + ", has no 'end'.",
                                    "  Action: close every 'subsection NAME' with a line 'end'."}));
      }

      SourceLine includer; ///< the line that named this file; line 0 for the outermost

    private:
      fs::path                  path;
      const ParameterTree      &known;
      unsigned int              depth;
      SectionPath               start;
      SectionPath               section;
      std::vector<unsigned int> opened_at;
      std::vector<Assignment>   assignments; ///< of this file alone
      SourceLine                where;
      std::size_t               file = 0, begin = 0, end = 0; ///< place in result.files; the statement in its text
      ScannedParameters        &result;

      fs::path folder() const
      {
        return path.has_parent_path() ? path.parent_path() : fs::path(".");
      }

      void refer_to(const std::string &statement, const std::string &typed, const std::string &found)
      {
        result.files[file].references.push_back({begin, end, statement, typed, found});
      }

      void read_statement(const std::string &typed)
      {
        const std::string statement = normalise(typed);
        const std::size_t blank     = statement.find(' ');
        std::string       keyword   = statement.substr(0, blank);
        const std::string rest      = blank == std::string::npos ? "" : statement.substr(blank + 1);
        if (std::all_of(keyword.begin(), keyword.end(), [](const unsigned char c) { return std::isupper(c); }))
          std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                         [](const unsigned char c) { return std::tolower(c); });
        if (statement.empty())
          return;
        if (keyword == "subsection" && !rest.empty())
          enter(rest);
        else if (keyword == "end" && rest.empty())
          leave();
        else if (keyword == "set" && !rest.empty())
          add(read_assignment(section, rest, where, known));
        else if (keyword == "include" && !rest.empty())
          include(behind_first_word(typed));
        else
          throw InputError(describe_bad_statement(where, statement));
      }

      void enter(const std::string &name)
      {
        SectionPath inner = section;
        inner.push_back(name);
        if (!known.has_section(inner))
          throw InputError(
            describe_unknown_section(where, section, opened_at.empty() ? 0 : opened_at.back(), name, known));
        section = inner;
        opened_at.push_back(where.line);
        result.text += "subsection " + name + "\n";
      }

      void leave()
      {
        if (opened_at.empty())
          throw InputError(message({where.text() + ": 'end' without an open subsection.",
                                    "  Action: remove the line, or open the section that it closes."}));
        opened_at.pop_back();
        section.pop_back();
        result.text += "end\n";
      }

      void add(Assignment assignment)
      {
        find_file(assignment);
        for (const Assignment &earlier : assignments)
          if (earlier.section == assignment.section && earlier.name == assignment.name)
            throw InputError(message(
              {where.text() + ", " + describe_section(section) + ": '" + assignment.name + "' is set a second time.",
               "  Read: " + quote(earlier.value) + " in line " + std::to_string(earlier.line) + ", now " +
                 quote(assignment.value) + ".",
               "  Action: remove one of the two lines."}));
        assignments.push_back(assignment);
        assignment.add_to(result, path.string());
      }

      void find_file(Assignment &assignment)
      {
        if (assignment.is_default || !names_file(*known.find(section, assignment.name)))
          return;
        const FoundFile found = find_beside(assignment.value, folder());
        refer_to("set " + assignment.name + " = ", assignment.value, found.path);
        if (!found.warning.empty())
          result.warnings.push_back(where.text() + ", '" + assignment.name + "': " + found.warning);
        assignment.value = found.path;
      }

      void include(const std::string &name)
      {
        // A chain of this length can only be a file that includes itself.
        if (depth == 16)
          throw InputError(
            message({where.text() + ": files include each other without end.", "  Read: include " + name}));
        if (result.included.size() >= 1000)
          throw InputError(message({where.text() + ": more than 1000 files are included.", "  Read: include " + name,
                                    "  Action: include each file once."}));
        FileScanner inner(path.parent_path() / name, section, known, depth + 1, result);
        inner.includer = where;
        refer_to("include ", name, (path.parent_path() / name).string());
        inner.scan();
        result.included.push_back((path.parent_path() / name).string());
      }
    };
  } // namespace

  std::string SourceLine::text() const
  {
    return line > 0 ? file + ", line " + std::to_string(line) : file;
  }

  void scan_parameter_file(const std::string &path, const ParameterTree &known, ScannedParameters &result)
  {
    FileScanner(path, {}, known, 0, result).scan();
  }

  ScannedValue scan_value(const std::string &text, const SourceLine &where, const ParameterTree &known)
  {
    const std::size_t equals = text.find('=');
    const std::size_t slash  = equals == std::string::npos ? equals : text.rfind('/', equals);
    if (equals == std::string::npos || slash == std::string::npos)
      throw InputError(
        message({where.text() + ": no section or no value.", "  Allowed: \"Section/Sub section/Entry=value\""}));
    if (first_not_utf8(text) < text.size())
      throw InputError(message({where.text() + ": the text is not in UTF-8.", "  Action: type it in UTF-8."}));
    if (text.find_first_of("#\n\\") != std::string::npos)
      throw InputError(message(
        {where.text() + ": '#', '\\' and line breaks cannot stand in a parameter file.", "  Action: leave them out."}));
    SectionPath        section;
    std::istringstream in(text.substr(0, slash));
    for (std::string name; std::getline(in, name, '/');)
      {
        name              = normalise(name);
        SectionPath inner = section;
        inner.push_back(name);
        if (!known.has_section(inner))
          throw InputError(describe_unknown_section(where, section, 0, name, known));
        section = inner;
      }
    return read_assignment(section, text.substr(slash + 1), where, known);
  }

  void scan_override(const std::string &text, const ParameterTree &known, ScannedParameters &result)
  {
    ScannedValue value = scan_value(text, {"--set " + quote(text), 0}, known);
    if (!value.is_default && names_file(*known.find(value.section, value.name)))
      value.value = find_from_here(value.value, result.folder).path;
    for (const std::string &name : value.section)
      result.text += "subsection " + name + "\n";
    Assignment{value, 0}.add_to(result, "");
    for (std::size_t k = 0; k < value.section.size(); ++k)
      result.text += "end\n";
  }
} // namespace birdstrike
