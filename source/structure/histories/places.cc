#include "structure/histories/places.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::uint32_t parse_number(const std::string &text, const std::string &entry)
    {
      const auto numbers = parse_ids(text, entry);
      if (numbers.size() != 1)
        throw InputError(entry + ": cannot read the number '" + text + "'.\nAllowed: one whole number.");
      return numbers[0];
    }

    void require_name(const std::string &name, const std::vector<Place> &others, const std::string &entry)
    {
      if (name.find_first_of(" ,./\t") != std::string::npos)
        throw InputError(entry + ": the name '" + name +
                         "' holds a blank, a comma, a dot or a slash.\nNames become parts of columns: use letters, "
                         "digits, - and _.");
      if (std::any_of(others.begin(), others.end(), [&](const Place &place) { return place.name == name; }))
        throw InputError(entry + ": the name '" + name + "' is given twice.\nEach place has a name of its own.");
    }
  } // namespace

  std::vector<Place> parse_places(const std::string &text, const std::string &entry, const std::string &noun,
                                  const std::size_t n_options, const bool is_halved)
  {
    std::vector<Place> places;
    for (const auto &[name, value] : parse_pairs(text, entry))
      {
        require_name(name, places, entry);
        Place place;
        place.name  = name;
        auto pieces = dealii::Utilities::split_string_list(value, '|');
        if (pieces.size() > n_options + 1)
          throw InputError(fmt::format("{}: '{}: {}' has {} parts separated by '|'.\nAllowed: at most {}.", entry, name,
                                       value, pieces.size(), n_options + 1));
        place.options.assign(pieces.begin() + 1, pieces.end());
        place.options.resize(n_options);
        if (!noun.empty() && pieces[0].starts_with(noun))
          place.number = parse_number(pieces[0].substr(noun.size()), entry);
        else
          {
            const auto x = parse_numbers(pieces[0], 3, entry);
            place.point  = Point3(x[0], x[1], x[2]);
            if (is_halved && place.point[1] < 0.)
              throw InputError(fmt::format("{}: '{}' at {} lies in the half y < 0, which Case/Symmetry plane = y does "
                                           "not compute.\nGive the place at +y: there the same happens, mirrored.",
                                           entry, name, text_of(place.point)));
          }
        places.push_back(std::move(place));
      }
    return places;
  }

  std::string text_of(const Point3 &point)
  {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", point[0], point[1], point[2]);
  }
} // namespace birdstrike
