#pragma once

#include "structure/histories/shell_directors.h"
#include "structure/histories/watched_blade.h"

#include <array>
#include <vector>

namespace birdstrike
{
  /// Where a gauge is glued: a face of the blade, seen along the blade's normal (away from the struck side) or along
  /// that of the mesh.
  enum class GaugeFace
  {
    struck,
    other,
    bottom,
    top
  };

  /// Quadrilaterals of a shell's faces, at +-t/2 along its fibres.
  class ShellFaces
  {
  public:
    explicit ShellFaces(const WatchedBlade<ShellKind> &blade);

    void                  add(const Place &place, GaugeFace face, const std::string &entry, Warnings &warnings);
    std::array<Point3, 4> corners_at_rest(std::size_t k) const;
    std::array<Point3, 4> corners(std::size_t k) const;
    bool                  is_failed(std::size_t k) const;
    void                  follow()
    {
      directors.follow();
    }
    void archive(Archive &archive)
    {
      directors.archive(archive);
    }

  private:
    WatchedBlade<ShellKind> blade;
    ShellDirectors          directors;
    std::vector<double>     zeta; ///< -1 or 1
  };

  /// Facets of a body's skin.
  class SolidFaces
  {
  public:
    explicit SolidFaces(const WatchedBlade<SolidKind> &blade);

    void                  add(const Place &place, GaugeFace face, const std::string &entry, Warnings &warnings);
    std::array<Point3, 4> corners_at_rest(std::size_t k) const;
    std::array<Point3, 4> corners(std::size_t k) const;
    bool                  is_failed(std::size_t k) const;
    void                  follow()
    {
    }
    void archive(Archive &)
    {
    }

  private:
    WatchedBlade<SolidKind>    blade;
    std::vector<std::uint32_t> facet; ///< of the mesh's `boundary`
  };
} // namespace birdstrike
