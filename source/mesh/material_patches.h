#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// Patches of a built-in blade in shares of its span (0 root, 1 tip) and chord (0 leading edge, 1 trailing edge), of
  /// a list "s0 s1 c0 c1: id; ..."; later patches win. Lines of nodes lie on their borders, so that a patch keeps its
  /// size on any mesh: cells that are taken by their centres change it by up to half a cell on each side.
  class MaterialPatches
  {
  public:
    /// Throws InputError.
    explicit MaterialPatches(const std::string &list);

    /// Moves lines that divide the whole span or chord (ascending from 0 to 1) onto the borders: the nearest line to
    /// each, the others between them by the same share as before. Throws InputError where there are too few.
    std::vector<double> lines_along_span(std::vector<double> shares) const;
    std::vector<double> lines_along_chord(std::vector<double> shares) const;

    unsigned int id_at(double s, double c) const; ///< 0 outside of all

    /// Whether the left half of the chord is the right one's mirror image.
    bool are_symmetric() const;

    bool empty() const
    {
      return patches.empty();
    }

  private:
    struct Patch
    {
      double       s0, s1, c0, c1;
      unsigned int id;
    };
    std::vector<Patch>  patches;
    std::vector<double> span_borders, chord_borders; ///< inside, ascending, each once
  };
} // namespace birdstrike
