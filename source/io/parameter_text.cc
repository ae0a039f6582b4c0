#include "io/parameter_messages.h"
#include "io/parameter_scan.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/text_file.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

namespace birdstrike
{
  namespace fs = std::filesystem;

  std::size_t first_not_utf8(const std::string &text)
  {
    const auto byte = [&text](const std::size_t at) { return static_cast<unsigned char>(text[at]); };
    for (std::size_t k = 0; k < text.size();)
      {
        const std::size_t n = byte(k) < 0x80                     ? 1
                              : byte(k) < 0xC2 || byte(k) > 0xF4 ? 0
                              : byte(k) < 0xE0                   ? 2
                              : byte(k) < 0xF0                   ? 3
                                                                 : 4;
        if (n == 0 || k + n > text.size())
          return k;
        for (std::size_t j = k + 1; j < k + n; ++j)
          if ((byte(j) & 0xC0) != 0x80)
            return k;
        if ((byte(k) == 0xE0 && byte(k + 1) < 0xA0) || (byte(k) == 0xED && byte(k + 1) > 0x9F) ||
            (byte(k) == 0xF0 && byte(k + 1) < 0x90) || (byte(k) == 0xF4 && byte(k + 1) > 0x8F))
          return k;
        k += n;
      }
    return text.size();
  }

  std::string read_parameter_text(const fs::path &path, const SourceLine &includer)
  {
    constexpr std::size_t largest = 16 << 20; // bytes
    std::ifstream         file(path, std::ios::binary);
    if (!file || fs::is_directory(path))
      throw InputError(describe_missing_file(path, includer));
    std::string             whole;
    std::array<char, 65536> buffer;
    while (whole.size() <= largest && (file.read(buffer.data(), buffer.size()), file.gcount() > 0))
      whole.append(buffer.data(), static_cast<std::size_t>(file.gcount()));
    const std::string included  = includer.line > 0 ? "  Included by " + includer.text() + "." : "";
    const bool        is_larger = whole.size() > largest;
    whole                       = decode_text(std::move(whole));
    if (whole.find('\0') != std::string::npos)
      throw InputError(message({"'" + path.string() + "' is no parameter file: it holds bytes that are no text.",
                                included, "  Allowed: text in UTF-8 or UTF-16."}));
    if (is_larger)
      throw InputError(message({"'" + path.string() + "' is no parameter file: it is larger than 16 MiB.", included}));
    if (const std::size_t place = first_not_utf8(whole); place < whole.size())
      {
        const auto n_lines = std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(place), '\n');
        throw InputError(message(
          {SourceLine{path.string(), static_cast<unsigned int>(1 + n_lines)}.text() + ": the text is not in UTF-8.",
           "  Action: save the file in UTF-8 (an editor may have saved it as Latin-1)."}));
      }
    return whole;
  }
} // namespace birdstrike
