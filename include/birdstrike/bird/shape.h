#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// The body of the bird in its own frame: centre at the origin, axis along z. Lengths in m.
  ///
  /// Dimensions follow from volume V = m/rho and r = length/diameter:
  ///   cylinder V = pi r D^3/4; hemispherical ends V = pi D^3 (r/4 - 1/12); ellipsoid of revolution V = pi r D^3/6;
  ///   sphere: the ellipsoid with r = 1; slab: its given lengths.
  class Shape
  {
  public:
    explicit Shape(const BirdParameters &parameters);

    bool contains(const Point3 &p) const;

    double diameter() const
    {
      return D;
    }
    double length() const
    {
      return L;
    }
    double volume() const
    {
      return V;
    }
    const Point3 &half_lengths() const ///< of the enclosing box
    {
      return half;
    }
    double bounding_radius() const
    {
      return kind == BirdShape::cylinder || kind == BirdShape::slab ? half.norm() : half.maxCoeff();
    }
    bool is_slab() const
    {
      return kind == BirdShape::slab;
    }

  private:
    BirdShape kind;
    double    V = 0., D = 0., L = 0.;
    Point3    half;
  };
} // namespace birdstrike
