#include "mesh/files/vtk/words.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr const char *blanks = " \t\f\v";
    constexpr const char *remedy = "Save it again as VTK legacy, ASCII.";
  } // namespace

  std::string_view VtkWords::peek()
  {
    std::size_t begin = rest.find_first_not_of(blanks);
    while (begin == std::string_view::npos)
      {
        if (!next())
          return {};
        rest  = text();
        begin = rest.find_first_not_of(blanks);
      }
    rest.remove_prefix(begin);
    return rest.substr(0, std::min(rest.find_first_of(blanks), rest.size()));
  }

  std::string_view VtkWords::word()
  {
    const auto found = peek();
    rest.remove_prefix(found.size());
    return found;
  }

  void VtkWords::skip_line()
  {
    peek();
    rest = {};
  }

  std::string_view VtkWords::must_word()
  {
    const auto found = word();
    if (found.empty())
      refuse("the file ends too early", remedy);
    return found;
  }

  double VtkWords::must_number()
  {
    return number(must_word());
  }

  VtkWords::Id VtkWords::must_id()
  {
    constexpr double largest = 1e15; // a double has each whole number up to here
    const auto       field   = must_word();
    const double     value   = number(field);
    if (std::abs(value) > largest || value != std::floor(value))
      refuse("'" + std::string(field) + "' stands where a whole number must stand", remedy);
    return static_cast<Id>(value);
  }

  std::size_t VtkWords::must_count()
  {
    constexpr Id largest = 4'000'000'000; // the product of two is a number
    const Id     n       = must_id();
    if (n < 0 || n > largest)
      refuse("the number " + std::to_string(n) + " of things is no such number", remedy);
    return static_cast<std::size_t>(n);
  }

  void VtkWords::skip_words(const std::size_t n)
  {
    for (std::size_t k = 0; k < n; ++k)
      must_word();
  }

  void VtkWords::skip_lines(const std::size_t n)
  {
    rest = {};
    for (std::size_t k = 0; k < n; ++k)
      if (!next())
        refuse("the file ends too early", remedy);
  }

  std::vector<VtkWords::Id> VtkWords::must_ids(const std::size_t n)
  {
    std::vector<Id> ids;
    for (std::size_t k = 0; k < n; ++k)
      ids.push_back(must_id());
    return ids;
  }

  void VtkWords::skip_metadata()
  {
    rest = {};
    while (next() && !text().empty())
      ;
  }
} // namespace birdstrike
