#include "structure/deformable_blade.h"
#include "structure/rigid_plate.h"
#include <birdstrike/structure/make_blade.h>

namespace birdstrike
{
  std::unique_ptr<Blade> make_blade(const BladeParameters &parameters, ThreadPool &pool)
  {
    parameters.check();
    switch (parameters.kind)
      {
      case BladeKind::shell:
        return std::make_unique<ShellBlade>(parameters, pool);
      case BladeKind::solid:
        return std::make_unique<SolidBlade>(parameters, pool);
      case BladeKind::rigid:
        return std::make_unique<RigidPlate>(parameters);
      case BladeKind::none:
        break;
      }
    return nullptr;
  }
} // namespace birdstrike
