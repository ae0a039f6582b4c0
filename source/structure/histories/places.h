#pragma once

#include <birdstrike/core/number.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// One item of a list of Output/Histories: "name: x y z | option | ..." or "name: node 17 | ...".
  struct Place
  {
    std::string                  name;
    std::optional<std::uint32_t> number;                 ///< of a node or element, as fields show it; or:
    Point3                       point = Point3::Zero(); ///< m, before the strike
    std::vector<std::string>     options;
  };

  /// `noun`: what numbers are of, "node" or "element"; none: places are points. Throws InputError for what cannot be
  /// read, names that are taken or hold a blank, comma, dot or slash, too many options, and (of a half) points at y <
  /// 0.
  std::vector<Place> parse_places(const std::string &text, const std::string &entry, const std::string &noun,
                                  std::size_t n_options, bool is_halved);

  std::string text_of(const Point3 &point); ///< "(0.1, 0, 0) m"
} // namespace birdstrike
