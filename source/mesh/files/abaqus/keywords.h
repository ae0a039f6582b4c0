#pragma once

#include "mesh/files/abaqus/keyword_line.h"
#include "mesh/files/keyword_families.h"

namespace birdstrike
{
  /// Of a keyword of Abaqus ("Keywords Reference Guide") or CalculiX that the reader does not take itself.
  KeywordUse abaqus_keyword(const AbaqusKeyword &keyword);
} // namespace birdstrike
