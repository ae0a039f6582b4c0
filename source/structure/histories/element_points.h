#pragma once

#include "structure/histories/shell_directors.h"
#include "structure/histories/watched_blade.h"

namespace birdstrike
{
  /// What is known at a point of an element; stress and strain xx, yy, zz, xy, yz, zx in global axes, zero once the
  /// element has failed.
  struct PointValues
  {
    std::array<double, 6> stress{}, strain{}; ///< Pa (Cauchy); logarithmic (strain.h)
    double                plastic_strain = 0.;
    double                thickness      = 0.; ///< m, of shells
    bool                  is_failed      = false;
  };

  /// Watched points of shells: of metals the integration point through the thickness that is nearest to a layer, of
  /// plies the layer itself; means over those in the plane. The strain is that at the middle of the element, of the
  /// layer there: across it that of plane stress (plies: none).
  class ShellPoints
  {
  public:
    explicit ShellPoints(const WatchedBlade<ShellKind> &blade);

    void        add(std::uint32_t element, double layer);
    std::string describe(std::size_t k) const; ///< "element 17 at (..) m, point 5 of 5 through the thickness (0.906)"
    PointValues values(std::size_t k) const;
    void        follow()
    {
      directors.follow();
    }
    void archive(Archive &archive)
    {
      directors.archive(archive);
    }

  private:
    const ShellMesh     &mesh;
    const ShellElements &elements;
    ShellDirectors       directors;
    std::vector<double>  height; ///< 2 z/t
  };

  /// Watched points of bricks: the mean of the element (layer 0), or the middle of the face on the side of minus (-1)
  /// or plus (1) the blade's normal (SolidElements::face_state; with the brick's own stress across, for a face may lie
  /// within the blade or under the bird). Without a clamped root the faces are those of the element's third axis.
  class SolidPoints
  {
  public:
    explicit SolidPoints(const WatchedBlade<SolidKind> &blade);

    void        add(std::uint32_t element, double layer);
    std::string describe(std::size_t k) const;
    PointValues values(std::size_t k) const;
    void        follow()
    {
    }
    void archive(Archive &)
    {
    }

  private:
    struct Watched
    {
      std::uint32_t element;
      int           layer;     ///< -1, 0, 1
      unsigned int  axis;      ///< of the reference cube, through the thickness
      bool          is_turned; ///< against the blade's normal
    };
    WatchedBlade<SolidKind> blade;
    std::vector<Watched>    watched;
  };
} // namespace birdstrike
