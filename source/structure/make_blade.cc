#include "structure/deformable_blade.h"
#include "structure/rigid_plate.h"
#include <birdstrike/core/log.h>
#include <birdstrike/structure/make_blade.h>

#include <spdlog/spdlog.h>

namespace birdstrike
{
  std::unique_ptr<Blade> make_blade(const BladeParameters &parameters, ThreadPool &pool)
  {
    parameters.check();
    for (const std::string &entry : parameters.unused_entries())
      log().warn("Blade/{} is set, and means nothing for a blade of kind '{}'.", entry, parameters.kind);
    if (parameters.kind == "shell")
      return std::make_unique<ShellBlade>(parameters, pool);
    if (parameters.kind == "solid")
      return std::make_unique<SolidBlade>(parameters, pool);
    if (parameters.kind == "rigid")
      return std::make_unique<RigidPlate>(parameters);
    return nullptr;
  }
} // namespace birdstrike
