#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Names of nested sections, outermost first; empty at the top of the file.
  using SectionPath = std::vector<std::string>;

  /// "Bird/Material"; "the top level" for the empty path.
  std::string to_string(const SectionPath &section);

  /// One declared entry with everything that may be said about it.
  struct KnownEntry
  {
    SectionPath section;
    std::string name;
    std::string value;         ///< when the tree was made, or last updated
    std::string default_value; ///< as declared
    std::string text;          ///< the sentence, without its unit
    std::string unit;          ///< "kg", "-"
    std::string pattern;       ///< deal.II's description, for Patterns::pattern_factory
    std::string range;         ///< the same in words: "a number, at least 0"

    bool allows(const std::string &value) const;
  };

  /// All declared entries in the order of their declaration: what diagnostics and printouts look names up in.
  class ParameterTree
  {
  public:
    explicit ParameterTree(const dealii::ParameterHandler &prm);

    /// Takes the present values of the handler that it was made from.
    void update_values(const dealii::ParameterHandler &prm);

    const std::vector<KnownEntry> &entries() const &;
    const std::vector<KnownEntry> &entries() const && = delete; // a loop over a temporary tree would outlive it

    /// nullptr if there is no such entry.
    const KnownEntry *find(const SectionPath &section, const std::string &name) const;
    bool              has_section(const SectionPath &section) const;

    /// Names of the entries (or of the subsections) directly in this section.
    std::vector<std::string> entry_names(const SectionPath &section) const;
    std::vector<std::string> subsection_names(const SectionPath &section) const;

    /// The sections that hold an entry of exactly this name.
    std::vector<SectionPath> sections_with(const std::string &name) const;

  private:
    std::vector<KnownEntry>  all;
    std::vector<SectionPath> sections;
  };

  std::string lower_case(std::string text);

  /// The candidate with the least edit distance (Levenshtein 1966, letters compared without case), or "" if none is
  /// closer than half of the length of `name`.
  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);
} // namespace birdstrike
