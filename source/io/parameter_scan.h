#pragma once

#include "io/parameter_tree.h"
#include <birdstrike/io/parameter_file.h>

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Where a value was read: a line of a file, or an override of the command line (line 0).
  struct SourceLine
  {
    std::string  file;
    unsigned int line = 0;

    /// "frontal.prm, line 17" or "--set Bird/Mass=2".
    std::string text() const;
  };

  /// A statement of a parameter file that names another file.
  struct FileReference
  {
    std::size_t begin, end;  ///< of the statement in the text, without its line end
    std::string statement;   ///< "include " or "set File = "
    std::string typed, path; ///< the name as it was typed, and where the file is
  };

  /// A parameter file as it was read.
  struct ScannedFile
  {
    std::string                path, text;
    std::vector<FileReference> references = {};
  };

  /// What is made of files and overrides.
  struct ScannedParameters
  {
    std::string              text;     ///< as deal.II's ParameterHandler parses it
    std::string              original; ///< the outermost file as it is
    GivenEntries             given;
    std::size_t              n_read = 0; ///< entries, in order
    std::vector<std::string> included;   ///< files, in the order of reading
    std::vector<ScannedFile> files;      ///< all of them, the outermost first
    std::vector<std::string> warnings;   ///< of where files were found
    std::string              folder;     ///< of the outermost file
  };

  /// Adds the text of a parameter file as deal.II's ParameterHandler parses it: with the included files in their
  /// places, which are looked for beside the file that includes them, and switches (on, off, yes, no) as true and
  /// false.
  ///
  /// deal.II 9.4 answers a misspelt entry with a dump of its internals: so the first fault is located here. Raises
  /// InputError, at most six lines, with file, line and nearest name. An entry set twice in one file is refused; a file
  /// may set again what it included.
  void scan_parameter_file(const std::string &path, const ParameterTree &known, ScannedParameters &result);

  /// A value of an entry, as deal.II takes it.
  struct ScannedValue
  {
    SectionPath section;
    std::string name, value;
    bool        is_default; ///< as if nothing had set it
  };

  /// Reads "Section/Sub section/Entry=value" of the command line; blanks around '/' and '=' do not count.
  ScannedValue scan_value(const std::string &text, const SourceLine &where, const ParameterTree &known);

  /// The same of the option --set, as if the line stood in the file.
  void scan_override(const std::string &text, const ParameterTree &known, ScannedParameters &result);

  /// Where a text stops to be UTF-8 (RFC 3629: no overlong forms, halves of pairs); its size if nowhere.
  std::size_t first_not_utf8(const std::string &text);

  /// The text of a parameter file (core/text/text_file.h), read once, for it may be a pipe. Raises InputError for what
  /// cannot be read, is larger than 16 MiB (/dev/zero never ends), no text or in neither UTF-8 nor UTF-16.
  std::string read_parameter_text(const std::filesystem::path &path, const SourceLine &includer);
} // namespace birdstrike
