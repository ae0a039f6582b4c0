#include "structure/nodes/initial_spin.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  Point3 read_initial_spin(const BladeParameters::Loads &loads)
  {
    Point3 spin = Point3::Zero();
    if (!is_present(loads.initial_spin))
      return spin;
    const double     origin[3] = {0., 0., 0.};
    const Expression expression(loads.initial_spin, 3, "Loads/Initial spin");
    for (unsigned int d = 0; d < 3; ++d)
      spin[d] = expression.value(origin, 0., d);
    return spin;
  }

  void require_no_spin(const Point3 &spin, const double velocity, const Point3 &x)
  {
    constexpr double round_off = 1e-9;
    if (spin.norm() > 0. && std::abs(velocity) > round_off * spin.norm() * (1. + x.norm()))
      throw InputError(
        fmt::format("Blade/Loads/Initial spin: a support constrains the node at ({:.4g}, {:.4g}, {:.4g}) m, which the "
                    "spin moves.\nThe blade would swing about a root that stands still: let the hub turn "
                    "(Blade/Spin/Speed), or leave these nodes free\n(Blade/Supports/Clamped, Hub, Held).",
                    x[0], x[1], x[2]));
  }
} // namespace birdstrike
