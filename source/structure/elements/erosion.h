#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>
#include <birdstrike/material/failure.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace birdstrike
{
  /// What elements of a metal that can fail hold besides, shells and bricks alike.
  ///
  /// An element fails within its batch: its stresses become zero, and so its forces of that step. From the next step on
  /// its lane works on the records of a square (or cube) that rests, and so goes on without stress, force, vote on the
  /// step or anything that is not finite. It fails when `n_needed` of its points have, or when it collapses: its stable
  /// step falls below the share Failure::smallest_step of what it was at first, or it is turned inside out.
  struct Erosion
  {
    struct OfBatch
    {
      Lanes         alive     = 1.;                                      ///< 0 where failed
      Lanes         size      = 0.;                                      ///< m, at the start
      Lanes         ductility = 1.;                                      ///< factor on the failure strain, by it
      Lanes         energy    = 0.;                                      ///< J, eroded, cumulative, by element
      Lanes         allowed   = std::numeric_limits<double>::infinity(); ///< bound (frequency, eigenvalue) of collapse
      std::uint32_t dying     = 0; ///< bits of the lanes that have failed in the present step
      std::uint32_t collapsed = 0; ///< of these, by collapse
    };
    AlignedVector<OfBatch>            batches;
    std::vector<AlignedVector<Lanes>> damage;           ///< [sections], D of their points; empty while elastic
    unsigned int                      n_needed    = 1;  ///< failed points that make an element fail
    std::size_t                       n_failed    = 0;  ///< elements, not only owned ones
    std::size_t                       n_collapsed = 0;  ///< owned ones of these
    double                            mass        = 0.; ///< kg, of the failed that are owned

    /// What a lane's element is given by its size (m), copies included.
    void set_size(const std::size_t slot, const SizeFactors &factors, const double size)
    {
      batches[slot / n_lanes].size[slot % n_lanes]      = size;
      batches[slot / n_lanes].ductility[slot % n_lanes] = factors.at(size);
    }

    bool is_failed(const std::size_t element) const
    {
      return lane(batches[element / n_lanes].alive, element % n_lanes) == 0.;
    }

    /// Notes the lanes of a batch that fail, and the energy (J) of these or of their points; only `n_elements` lanes
    /// are no copies.
    void book(const std::size_t batch, const std::size_t n_elements, const LanesMask &fails, const Lanes &eroded)
    {
      OfBatch &of_batch = batches[batch];
      for (std::size_t k = 0; k < n_lanes; ++k)
        {
          if (k < n_elements)
            of_batch.energy[k] += eroded[k];
          if (of_batch.alive[k] > 0. && fails[k])
            of_batch.dying |= 1u << k;
        }
    }

    /// Counts an element out.
    void count_out(const bool is_owned, const double element_mass, const bool collapses)
    {
      ++n_failed;
      n_collapsed += is_owned && collapses;
      mass += is_owned ? element_mass : 0.;
    }

    double largest_damage(const std::size_t element, const std::size_t n_sections) const
    {
      double largest = 0.;
      for (std::size_t i = 0; i < n_sections; ++i)
        for (const Lanes &d : damage[n_sections * (element / n_lanes) + i])
          largest = std::max(largest, lane(d, element % n_lanes));
      return largest;
    }

    std::size_t count_failed_points(const std::size_t element, const std::size_t n_sections) const
    {
      std::size_t count = 0;
      for (std::size_t i = 0; i < n_sections; ++i)
        for (const Lanes &d : damage[n_sections * (element / n_lanes) + i])
          count += lane(d, element % n_lanes) >= 1.;
      return count;
    }

    std::size_t bytes() const
    {
      std::size_t sum = batches.capacity() * sizeof(OfBatch) + damage.capacity() * sizeof(damage[0]);
      for (const auto &of_section : damage)
        sum += of_section.capacity() * sizeof(Lanes);
      return sum;
    }
  };

  /// Number of failed points (of n) that make an element fail, of which it needs a share.
  inline unsigned int n_points_to_fail(const double failed_share, const std::size_t n)
  {
    return std::max(1u, static_cast<unsigned int>(std::ceil(failed_share * static_cast<double>(n) - 1e-9)));
  }

  /// Points with D >= 1 of n.
  template <class Number>
  Number count_failed(const Number *damage, const std::size_t n)
  {
    Number count = 0.;
    for (std::size_t k = 0; k < n; ++k)
      count += select(damage[k] >= Number(1.), Number(1.), Number(0.));
    return count;
  }
} // namespace birdstrike
