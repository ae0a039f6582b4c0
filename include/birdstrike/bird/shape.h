#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/number.h>

#include <optional>

namespace birdstrike
{
  /// The body of the bird, or of a slice of it. Lengths in m.
  ///
  /// Dimensions of the whole follow from volume V = m/rho and r = length/diameter:
  ///   cylinder V = pi r D^3/4; hemispherical ends V = pi D^3 (r/4 - 1/12); ellipsoid of revolution V = pi r D^3/6;
  ///   sphere: the ellipsoid with r = 1; slab: its given lengths.
  ///
  /// Points are those of its own frame: the bird's, centre at the origin, axis along z; of a slice halfway between its
  /// planes, z along their normal. A slice is what lies between the planes; what it has of volume,
  /// source/bird/round_body.h.
  class Shape
  {
  public:
    explicit Shape(const BirdParameters &parameters);

    bool contains(const Point3 &p) const;

    /// Of a slice: that of the circle as large as its largest section along the planes.
    double diameter() const
    {
      return D;
    }
    /// Of a slice: between the planes, as far as the bird reaches; 0 of one that misses the bird.
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
    bool has_flat_ends() const ///< across z
    {
      return kind == BirdShape::cylinder || is_slice();
    }
    bool is_slice() const
    {
      return cut.has_value();
    }

    /// The point p in the frame of the whole bird.
    Point3 in_bird(const Point3 &p) const
    {
      return cut ? Point3(cut->middle + cut->axes * p) : p;
    }
    double whole_length() const
    {
      return cut ? 2. * whole_half[2] : L;
    }
    double whole_diameter() const
    {
      return cut ? 2. * whole_half[0] : D;
    }
    double reach_along_normal() const ///< of the whole bird from its centre
    {
      return cut ? cut->reach : whole_half[2];
    }

  private:
    struct Cut
    {
      Matrix3<double> axes;   ///< of the slice's frame, in the bird's
      Point3          middle; ///< between the planes, likewise
      double          reach;
    };

    void cut_out(const BirdParameters &parameters);
    bool whole_contains(const Point3 &p) const;

    BirdShape          kind;
    double             V = 0., D = 0., L = 0.;
    Point3             half, whole_half;
    std::optional<Cut> cut;
  };
} // namespace birdstrike
