#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  struct EosParameters;
  struct MetalParameters;

  /// An entry that was changed from its default and that no law of the material reads.
  struct UnusedEntry
  {
    std::string name;   ///< "Hardening modulus"
    std::string reason; ///< "Hardening is perfect"
  };

  /// Throws InputError as MetalParameters::metal does.
  std::vector<UnusedEntry> unused_entries(const MetalParameters &metal);
  std::vector<UnusedEntry> unused_entries(const EosParameters &liquid);
} // namespace birdstrike
