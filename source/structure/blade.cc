#include <birdstrike/core/errors.h>
#include <birdstrike/structure/blade.h>

#include <algorithm>

// By itself: what reads requests needs no blade of any kind (tests/fuzz).
namespace birdstrike
{
  namespace
  {
    const char *const has_no_elements =
      "Blade/Kind: a rigid surface has neither static equilibrium nor modes.\nSet it to shell or solid.";
  }

  PeakPlasticStrain find_largest(const std::vector<PeakPlasticStrain> &of_sections)
  {
    const auto most = std::max_element(of_sections.begin(), of_sections.end(),
                                       [](const auto &a, const auto &b) { return a.value < b.value; });
    return most == of_sections.end() ? PeakPlasticStrain() : *most;
  }

  StaticReport Blade::find_equilibrium()
  {
    throw InputError(has_no_elements);
  }

  VibrationModes Blade::compute_modes(std::size_t, std::size_t)
  {
    throw InputError(has_no_elements);
  }
} // namespace birdstrike
