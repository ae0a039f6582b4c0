#pragma once

#include <map>
#include <utility>

namespace birdstrike
{
  /// Density (kg/m^3) of the cells with a material id: one for all, or others for some.
  class DensityLaw
  {
  public:
    DensityLaw(const double all, std::map<unsigned int, double> some = {}) : all(all), some(std::move(some))
    {
    }

    double operator()(const unsigned int material_id) const
    {
      const auto found = some.find(material_id);
      return found != some.end() ? found->second : all;
    }

  private:
    double                         all;
    std::map<unsigned int, double> some;
  };
} // namespace birdstrike
