#include <birdstrike/blade/make_blade.h>
#include <birdstrike/blade/rigid_plate.h>
#include <birdstrike/blade/shell_blade.h>
#include <birdstrike/core/errors.h>

namespace birdstrike
{
  std::unique_ptr<Blade> make_blade(const BladeParameters &parameters, ThreadPool &pool)
  {
    parameters.check();
    if (parameters.kind == "shell")
      return std::make_unique<ShellBlade>(parameters, pool);
    if (parameters.kind == "rigid")
      return std::make_unique<RigidPlate>(parameters);
    return nullptr;
  }
} // namespace birdstrike
