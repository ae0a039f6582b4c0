#include <birdstrike/core/text/text_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

    enum class Encoding
    {
      one_byte, ///< UTF-8, or what has a byte a letter
      utf16_little_endian,
      utf16_big_endian
    };

    /// Letters of Latin scripts have a byte 0 in UTF-16; here each of the first ones.
    bool has_zeros_at(const std::string_view bytes, const std::size_t first)
    {
      constexpr std::size_t most = 256;
      const std::size_t     n    = std::min(bytes.size() & ~std::size_t(1), most);
      for (std::size_t k = 0; k < n; ++k)
        if ((bytes[k] == '\0') != (k % 2 == first))
          return false;
      return n >= 4;
    }

    Encoding find_encoding(const std::string_view bytes)
    {
      using namespace std::string_view_literals;
      if (bytes.starts_with("\xFF\xFE"sv) || has_zeros_at(bytes, 1))
        return Encoding::utf16_little_endian;
      if (bytes.starts_with("\xFE\xFF"sv) || has_zeros_at(bytes, 0))
        return Encoding::utf16_big_endian;
      return Encoding::one_byte;
    }

    void append_utf8(std::string &text, const char32_t letter)
    {
      const auto add = [&text](const char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
      if (letter < 0x80)
        return add(letter);
      if (letter < 0x800)
        add(0xC0 | letter >> 6);
      else if (letter < 0x10000)
        {
          add(0xE0 | letter >> 12);
          add(0x80 | (letter >> 6 & 0x3F));
        }
      else
        {
          add(0xF0 | letter >> 18);
          add(0x80 | (letter >> 12 & 0x3F));
          add(0x80 | (letter >> 6 & 0x3F));
        }
      add(0x80 | (letter & 0x3F));
    }

    std::string utf8_of_utf16(const std::string_view bytes, const bool is_little)
    {
      constexpr char32_t no_letter = 0xFFFD, mark = 0xFEFF;
      const auto         unit = [&](const std::size_t k) {
        const auto low  = static_cast<unsigned char>(bytes[2 * k + (is_little ? 0 : 1)]),
                   high = static_cast<unsigned char>(bytes[2 * k + (is_little ? 1 : 0)]);
        return static_cast<char32_t>(high << 8 | low);
      };
      const auto        is_high = [](const char32_t u) { return u >= 0xD800 && u < 0xDC00; };
      const auto        is_low  = [](const char32_t u) { return u >= 0xDC00 && u < 0xE000; };
      const std::size_t n       = bytes.size() / 2;
      std::string       text;
      text.reserve(n);
      for (std::size_t k = n > 0 && unit(0) == mark ? 1 : 0; k < n; ++k)
        if (is_high(unit(k)) && k + 1 < n && is_low(unit(k + 1)))
          {
            append_utf8(text, 0x10000 + ((unit(k) - 0xD800) << 10) + (unit(k + 1) - 0xDC00));
            ++k;
          }
        else
          append_utf8(text, is_high(unit(k)) || is_low(unit(k)) ? no_letter : unit(k));
      if (bytes.size() % 2 == 1)
        append_utf8(text, no_letter);
      return text;
    }

    void end_lines_by_line_feeds(std::string &text)
    {
      const std::size_t first = text.find('\r');
      if (first == std::string::npos)
        return;
      std::size_t to = first;
      for (std::size_t from = first; from < text.size();)
        {
          if (text[from] != '\r')
            {
              text[to++] = text[from++];
              continue;
            }
          const std::size_t behind = std::min(text.find_first_not_of('\r', from), text.size());
          if (behind < text.size() && text[behind] == '\n')
            from = behind; // CR LF
          else
            {
              std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(to), behind - from, '\n');
              to += behind - from;
              from = behind;
            }
        }
      text.resize(to);
    }

    struct Binary
    {
      std::string_view first_bytes, what;
    };

    /// From the formats' own documents: RFC 1952, PKWARE's APPNOTE, bzip2, xz, 7-Zip, zstd, HDF5, netCDF, OLE2, PDF.
    const std::array<Binary, 10> &known_binaries()
    {
      using namespace std::string_view_literals;
      static const std::array<Binary, 10> all{
        {{"\x1F\x8B"sv, "an archive of gzip: unpack it first (gunzip)"},
         {"PK\x03\x04"sv,
          "an archive of zip or a workbook: unpack it, or save the sheet of Excel or LibreOffice as CSV"},
         {"BZh"sv, "an archive of bzip2: unpack it first (bunzip2)"},
         {"\xFD\x37zXZ\0"sv, "an archive of xz: unpack it first (unxz)"},
         {"7z\xBC\xAF\x27\x1C"sv, "an archive of 7-Zip: unpack it first"},
         {"\x28\xB5\x2F\xFD"sv, "an archive of zstd: unpack it first (unzstd)"},
         {"\x89HDF\n\x1A\n"sv, "HDF5 (MED, CGNS, Exodus, MATLAB): save it as text"}, // its CR LF decoded
         {"CDF"sv, "netCDF (Exodus): save it as text"},
         {"\xD0\xCF\x11\xE0"sv, "a workbook of old Excel: save the sheet as CSV"},
         {"%PDF"sv, "PDF: save the numbers as text"}}};
      return all;
    }

    /// Tabulators, ends of lines and of pages are text.
    bool is_control(const char letter)
    {
      return static_cast<unsigned char>(letter) < '\t';
    }
  } // namespace

  std::string decode_text(std::string bytes)
  {
    if (const Encoding encoding = find_encoding(bytes); encoding != Encoding::one_byte)
      bytes = utf8_of_utf16(bytes, encoding == Encoding::utf16_little_endian);
    else if (bytes.starts_with(utf8_mark))
      bytes.erase(0, utf8_mark.size());
    end_lines_by_line_feeds(bytes);
    if (bytes.ends_with('\x1A'))
      bytes.pop_back();
    return bytes;
  }

  std::optional<std::string> read_text_file(const fs::path &file, const std::size_t most)
  {
    std::error_code error;
    const auto      status = fs::status(file, error);
    if (!fs::is_regular_file(status) && !fs::is_fifo(status)) // what is neither may never end
      return {};
    std::ifstream in(file, std::ios::binary);
    if (!in)
      return {};
    std::string bytes;
    if (const auto n = fs::file_size(file, error); !error)
      bytes.reserve(std::min<std::size_t>(n, most));
    std::array<char, 65536> buffer;
    while (bytes.size() < most && (in.read(buffer.data(), buffer.size()), in.gcount() > 0))
      bytes.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    bytes.resize(std::min(bytes.size(), most));
    return decode_text(std::move(bytes));
  }

  std::string describe_no_text(const std::string_view text)
  {
    constexpr std::size_t most = 4096;
    if (const auto begin = text.substr(0, most); std::none_of(begin.begin(), begin.end(), is_control))
      return "";
    for (const Binary &each : known_binaries())
      if (text.starts_with(each.first_bytes))
        return std::string(each.what);
    return "bytes that are no text: save it as text";
  }

  std::optional<char> named_separator(std::string_view line)
  {
    constexpr std::string_view blanks = " \"\r";
    const std::size_t          first  = line.find_first_not_of(blanks);
    line.remove_prefix(std::min(first, line.size()));
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    std::string head(line.substr(0, 4));
    std::transform(head.begin(), head.end(), head.begin(), [](const unsigned char c) { return std::tolower(c); });
    if (line.size() != 5 || !head.starts_with("sep="))
      return {};
    return line[4];
  }
} // namespace birdstrike
