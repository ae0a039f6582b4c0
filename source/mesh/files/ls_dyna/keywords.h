#pragma once

#include "mesh/files/keyword_families.h"

namespace birdstrike
{
  /// Of a keyword of LS-DYNA ("Keyword User's Manual", the chapters of volumes I to III) that the reader does not take
  /// itself: upper case, without '*'.
  KeywordUse ls_dyna_keyword(const std::string &name);
} // namespace birdstrike
