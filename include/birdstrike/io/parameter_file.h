#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  class ParameterTree;
  struct ScannedFile;
} // namespace birdstrike
namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Anything with declare(ParameterHandler &) and check() const. The object must outlive the group.
  struct ParameterGroup
  {
    std::function<void(dealii::ParameterHandler &)> declare;
    std::function<void()>                           check;

    /// `section`: entered around declare(), for groups that declare in the present section; empty for groups that
    /// enter their own.
    template <class Parameters>
    static ParameterGroup of(Parameters &p, const std::string &section = "")
    {
      return {[&p, section](dealii::ParameterHandler &prm) {
                declare_in_section(prm, section, [&p](dealii::ParameterHandler &inner) { p.declare(inner); });
              },
              [&p] { p.check(); }};
    }

    static void declare_in_section(dealii::ParameterHandler &prm, const std::string &section,
                                   const std::function<void(dealii::ParameterHandler &)> &declare);
  };

  /// How an entry came to its value.
  struct GivenEntry
  {
    std::string                source; ///< a file; empty: the command line
    std::size_t                order;  ///< grows from entry to entry as they were read
    std::string                value;
    std::optional<std::string> before;     ///< its value by the sources before this one, if they gave one
    bool                       is_default; ///< given back, as if nothing had set it
  };

  /// Entries that are set, by "Section/Entry".
  using GivenEntries = std::map<std::string, GivenEntry>;

  /// The parameter file: owns the handler to which groups of parameters are bound, reads values into them and prints
  /// them. Raises InputError (at most six lines: file, line, section, what was read, what is allowed, nearest name) for
  /// bad input; never prints. A file that fails leaves the bound parameters half set: do not use them.
  class ParameterFile
  {
  public:
    explicit ParameterFile(const std::vector<ParameterGroup> &groups);
    ~ParameterFile();
    ParameterFile(const ParameterFile &)            = delete;
    ParameterFile &operator=(const ParameterFile &) = delete;

    /// Entries of a section that stand for those of another of the same entries.
    struct Inheritance
    {
      std::string section, from;
      std::string when; ///< entry of `section` that must be true
      /// What is given of the first entries, in `section` itself, stands for all of the second, which are not
      /// inherited then.
      struct Alternative
      {
        std::vector<std::string> given, replaced;
      };
      std::vector<Alternative> alternatives;
      std::vector<std::string> own; ///< entries that are never inherited
    };

    /// From now on read() gives what neither the file nor an override says of a section the values of the other one,
    /// before anything is checked. What was given there is given here, too.
    void inherit(const Inheritance &rule);

    /// Reads the file, then the overrides "Section/Entry=value", and checks every group.
    void read(const std::string &path, const std::vector<std::string> &overrides = {});

    /// Sets entries, "Section/Entry=value", without checking the groups again.
    void set(const std::vector<std::string> &overrides);

    /// Whether the file, one that it includes or an override has set the entry "Section/Entry".
    bool is_given(const std::string &entry) const;

    /// Whether the file sets or includes anything.
    bool says_anything() const;

    /// What they have set it to; empty where none has.
    std::string given_value(const std::string &entry) const;

    /// Other entries of a section that were set by a file before another one, or the command line, gave its entry
    /// `name` another value, and still hold; those at their defaults left out. A file may have meant them for its own
    /// value.
    std::vector<std::string> set_before(const std::string &section, const std::string &name) const;

    /// Whether any entry of a section, by its whole name, is not at its default.
    bool is_changed(const std::string &section) const;

    /// Files that the one that was read includes, in the order of reading.
    const std::vector<std::string> &included_files() const;

    /// All files that were read, the outermost first.
    const std::vector<ScannedFile> &scanned_files() const;

    /// Sentences about where the files were found that entries name; each begins with its line.
    const std::vector<std::string> &file_warnings() const;

    /// A sentence for the printed file, beside the entry "Section/Entry".
    void annotate(const std::string &entry, const std::string &sentence);

    /// The text of the file that was read, verbatim.
    const std::string &original() const;

    /// Every entry with its text, unit, range and default, at its present value: a file that can be read again and
    /// gives the same values to the last digit. Sections that would inherit and are at their defaults are left out
    /// unless `with_unused`.
    /// `other_values`: printed in the place of the present ones, by "Section/Entry".
    std::string as_prm(bool with_unused = false, const std::map<std::string, std::string> &other_values = {}) const;

    /// The same as JSON: sections nest, an entry is {"text", "unit", "range", "default", "value"}.
    std::string as_json() const;

    /// All entries at their present values; holds until the next read() or set().
    const ParameterTree &tree() const;

  private:
    void apply(const Inheritance &rule);
    void parse(const std::string &text);

    std::vector<Inheritance>                  inheritances;
    std::vector<ParameterGroup>               groups;
    std::unique_ptr<dealii::ParameterHandler> prm;
    std::unique_ptr<ParameterTree>            known; ///< what `prm` declares, and its values
    std::string                               original_text;
    std::map<std::string, std::string>        notes; ///< by entry
    GivenEntries                              given;
    std::vector<std::string>                  included;
    std::vector<ScannedFile>                  files;
    std::vector<std::string>                  warnings;
  };
} // namespace birdstrike
