#include "mesh/material_patches.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    const std::string entry      = "Blade/Mesh/Material patches";
    constexpr double  same_share = 1e-6; ///< borders nearer than this are one

    /// What of the borders lies inside, ascending, each once.
    std::vector<double> inner(std::vector<double> borders)
    {
      std::ranges::sort(borders);
      std::vector<double> result;
      for (const double border : borders)
        if (border > same_share && border < 1. - same_share && (result.empty() || border > result.back() + same_share))
          result.push_back(border);
      return result;
    }

    /// Which line, counted in elements from 0, a border takes that lies at `place` among n of them: the nearest; half
    /// way the one further from the nearer end, by the same rule from both ends.
    int nearest_line(const double place, const int n)
    {
      constexpr double half = 0.5 + 1e-9;
      return place < 0.5 * n ? static_cast<int>(std::floor(place + half)) : static_cast<int>(std::ceil(place - half));
    }

    std::vector<double> put_on(const std::vector<double> &borders, std::vector<double> shares,
                               const std::string &elements)
    {
      const int n = static_cast<int>(shares.size()) - 1, m = static_cast<int>(borders.size());
      if (m + 1 > n)
        throw InputError(entry + ": " + std::to_string(m) +
                         " borders cross the blade, and each needs a line of nodes.\nAllowed: more of " + elements +
                         " than that, here " + std::to_string(n) + ".");
      const std::vector<double> even          = shares;
      double                    border_before = 0.;
      int                       line_before   = 0;
      const auto                stretch = [&](const int line, const double border) { // those since the line before
        const double a = even[line_before], b = even[line];
        for (int k = line_before + 1; k < line; ++k)
          shares[k] = border_before + (even[k] - a) / (b - a) * (border - border_before);
        shares[line]  = border;
        line_before   = line;
        border_before = border;
      };
      for (int k = 0; k < m; ++k)
        {
          const auto   after = std::ranges::upper_bound(even, borders[k]);
          const int    i     = static_cast<int>(after - even.begin()) - 1;
          const double place = i + (borders[k] - even[i]) / (even[i + 1] - even[i]);
          stretch(std::clamp(nearest_line(place, n), line_before + 1, n - (m - k)), borders[k]);
        }
      if (m > 0)
        stretch(n, 1.);
      return shares;
    }
  } // namespace

  MaterialPatches::MaterialPatches(const std::string &list)
  {
    for (const auto &[where, id] : parse_pairs(list, entry))
      {
        const std::vector<unsigned int> ids = parse_ids(id, entry);
        const std::vector<double>       b   = parse_numbers(where, 4, entry);
        if (ids.size() != 1)
          throw InputError(entry + ": the patch '" + where + "' has the ids '" + id +
                           "'.\nAllowed: one material id a patch.");
        for (const std::size_t k : {0, 2})
          if (!(b[k] >= 0. && b[k + 1] <= 1. && b[k + 1] - b[k] > same_share))
            throw InputError(entry + ": cannot read '" + where +
                             "'.\nAllowed: 's0 s1 c0 c1', shares of the span and "
                             "of the chord from 0 to 1, the smaller first.");
        patches.push_back({b[0], b[1], b[2], b[3], ids[0]});
        span_borders.insert(span_borders.end(), {b[0], b[1]});
        chord_borders.insert(chord_borders.end(), {b[2], b[3]});
      }
    span_borders  = inner(span_borders);
    chord_borders = inner(chord_borders);
  }

  std::vector<double> MaterialPatches::lines_along_span(std::vector<double> shares) const
  {
    return put_on(span_borders, std::move(shares), "Blade/Mesh/Elements along span");
  }

  std::vector<double> MaterialPatches::lines_along_chord(std::vector<double> shares) const
  {
    return put_on(chord_borders, std::move(shares), "Blade/Mesh/Elements along chord");
  }

  unsigned int MaterialPatches::id_at(const double s, const double c) const
  {
    unsigned int id = 0;
    for (const Patch &patch : patches)
      if (patch.s0 <= s && s <= patch.s1 && patch.c0 <= c && c <= patch.c1)
        id = patch.id;
    return id;
  }

  bool MaterialPatches::are_symmetric() const
  {
    // Ids change at borders alone: the middle of each piece tells those of all of it.
    const auto middles = [](const std::vector<double> &borders) {
      std::vector<double> result;
      double              before = 0.;
      for (const double border : borders)
        {
          result.push_back(0.5 * (before + border));
          before = border;
        }
      result.push_back(0.5 * (before + 1.));
      return result;
    };
    for (std::size_t k = 0; k < chord_borders.size(); ++k)
      if (std::abs(chord_borders[k] + chord_borders[chord_borders.size() - 1 - k] - 1.) > same_share)
        return false;
    for (const double s : middles(span_borders))
      for (const double c : middles(chord_borders))
        if (id_at(s, c) != id_at(s, 1. - c))
          return false;
    return true;
  }
} // namespace birdstrike
