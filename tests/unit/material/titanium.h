#pragma once

#include <birdstrike/material/elasticity.h>

namespace birdstrike::test
{
  inline const Elasticity titanium{113.8e9, 0.342};
}
