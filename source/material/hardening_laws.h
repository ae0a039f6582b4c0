#pragma once

#include <birdstrike/core/named_choices.h>
#include <birdstrike/material/hardening.h>

namespace birdstrike
{
  const NamedChoices<HardeningLaw> &hardening_laws();
  const NamedChoices<RateLaw>      &rate_laws();
} // namespace birdstrike
