#include "io/aim/contradiction.h"
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

namespace birdstrike
{
  std::string shown(const Point3 &a)
  {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", a[0], a[1], a[2]);
  }

  void refuse_difference(const BirdParameters &bird, const std::string &entry, const std::string &found,
                         const std::string &other, const std::string &there)
  {
    throw InputError(fmt::format("{0}/{1} = {2} contradicts {0}/{3}, which gives {4}.\nLeave one of the two out (an "
                                 "entry of the file is reset by --set \"{0}/...=default\"), or correct it.",
                                 bird.section, entry, found, other, there));
  }
} // namespace birdstrike
