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
      log().warn("Blade/{} is set, and means nothing for a blade of kind '{}'.", entry,
                 blade_kinds().name(parameters.kind));
    for (std::size_t k = 1; k <= parameters.sections.size(); ++k)
      if (const auto &section = parameters.sections[k - 1];
          section.material_ids.empty() && section != BladeParameters::Section{})
        log().warn("Blade/{}Material ids is empty: no other entry of this section is used.",
                   BladeParameters::section_path(k));
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
