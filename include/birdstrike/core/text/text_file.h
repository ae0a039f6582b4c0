#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace birdstrike
{
  /// Text as every reader here takes it, from bytes as programs and editors write them: UTF-8 without its mark, lines
  /// that end in '\n' alone.
  ///
  /// UTF-16 is known by its mark, or by every other one of its first bytes being 0 (The Unicode Standard, 15.0, section
  /// 3.10); what is no letter there becomes U+FFFD. Ends of lines: LF, CR LF, CR (and CR CR LF, as a bad transfer
  /// leaves it). A Ctrl-Z at the end, by which old programs end a file, is left out. Other bytes stay as they are, also
  /// those that are not UTF-8.
  std::string decode_text(std::string bytes);

  /// The decoded text of a file or pipe, of its first `most` bytes if it is longer; none where it cannot be read or is
  /// something else (a folder, a device).
  std::optional<std::string> read_text_file(const std::filesystem::path &file, std::size_t most = -1);

  /// What a decoded text holds that is no text, as the end of a sentence ("a gzip archive: unpack it first"), by what
  /// its first bytes are; empty for text.
  std::string describe_no_text(std::string_view text);

  /// The separator that a spreadsheet's first line "sep=;" names (also in quotation marks, in any case); none: the line
  /// is no such one.
  std::optional<char> named_separator(std::string_view line);
} // namespace birdstrike
