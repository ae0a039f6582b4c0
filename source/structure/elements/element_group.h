#pragma once

#include "structure/elements/element_blocks.h"
#include "structure/elements/element_lane.h"
#include "structure/elements/erosion.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/simd/compress.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/core/simd/records.h>
#include <birdstrike/core/step_limit.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <string>
#include <tuple>

namespace birdstrike
{
  template <class Vector>
  std::size_t bytes_of(const Vector &v)
  {
    return v.capacity() * sizeof(typename Vector::value_type);
  }

  /// A number as messages show it.
  std::string text_of(double value);

  /// Batches of one chunk belong to one thread; sums over chunks do not depend on the number of threads.
  struct ElementChunk
  {
    Lanes plastic = 0., hourglass = 0., viscous = 0.; ///< J, cumulative
    Lanes bound = 0.;                                 ///< largest of the chunk
  };

  /// What a batch of elements has, whatever their kind: `bound` is that of omega^2 (shells, 1/s^2) or of 2/dt (bricks,
  /// which have a drag, 1/s).
  template <unsigned int n>
  struct ElementBatch
  {
    static constexpr unsigned int n_corners = n;

    Lanes         owned = 0.;         ///< 1, or 0: no element, or one that another process books and lets vote
    Lanes         inverse_mass;       ///< 1/kg, of the least mass that the nodes carry for the element
    Lanes         bound;              ///< see above
    std::uint32_t record[n][n_lanes]; ///< where the corners' records begin, in doubles
    std::uint32_t corner[n][n_lanes]; ///< which rows the corners' forces go to
  };

  /// Elements of one kind and one section, in batches of n_lanes (the last one is filled up with copies of the last
  /// element, whose forces and energies are never read); Elements has all groups of a blade. Records of nodes and rows
  /// of forces are those of all groups; behind the records of the nodes lie those of an element at rest, on which
  /// failed elements go on. Kernels are those of the heirs ShellGroup and SolidGroup.
  template <class Batch_, class Record_, class Row_, class Erosion_>
  class ElementGroup
  {
  public:
    using Batch                     = Batch_;
    using Record                    = Record_; ///< begins with the position (m), at t^{n+1}
    using ForceOnCorner             = Row_;
    static constexpr auto n_corners = Batch::n_corners;
    using Cell                      = std::array<std::uint32_t, n_corners>;

    /// Which elements, and where they read and write.
    struct Place
    {
      std::vector<std::uint32_t> number; ///< [n_elements], in the mesh
      std::vector<std::int64_t>  label;  ///< by which users know them
      std::vector<Cell>          cells;  ///< of these
      std::vector<Cell>
                    record_cells; ///< the same of the records of their corners; none where they are those of the nodes
      const Record *records;
      Row_         *corner_force;
      std::size_t   n_nodes;
      std::uint32_t spare_row; ///< of the group alone: what fills up its last batch writes there

      std::uint32_t record_of(const std::size_t element, const std::size_t corner) const
      {
        return record_cells.empty() ? cells[element][corner] : record_cells[element][corner];
      }
    };

    ElementGroup(Place place, const ElementBlocks &blocks)
      : place(std::move(place))
      , batches((n_elements() + n_lanes - 1) / n_lanes)
      , chunks((batches.size() + ElementBlocks::batches_per_chunk - 1) / ElementBlocks::batches_per_chunk)
    {
      for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
        for (std::uint32_t i = 0; i < n_corners; ++i)
          {
            Batch            &batch = batches[slot / n_lanes];
            const std::size_t k = slot % n_lanes, e = element_of(slot);
            batch.owned[k]     = slot == e ? 1. : 0.;
            batch.record[i][k] = this->place.record_of(e, i) * (sizeof(Record) / sizeof(double));
            batch.corner[i][k] =
              slot == e ? blocks.corner_row[n_corners * this->place.number[e] + i] : this->place.spare_row;
          }
    }

    std::size_t n_elements() const
    {
      return place.cells.size();
    }
    std::size_t n_elements_of(const std::size_t batch) const
    {
      return std::min<std::size_t>(n_lanes, n_elements() - batch * n_lanes);
    }
    std::size_t count_positive(const Lanes &of_elements, const std::size_t batch) const ///< without what fills it up
    {
      return static_cast<std::size_t>(std::popcount(to_bits(of_elements > 0.) & ((1u << n_elements_of(batch)) - 1u)));
    }
    std::size_t element_of(const std::size_t slot) const ///< of a lane, counted through all batches
    {
      return std::min(slot, n_elements() - 1);
    }
    bool is_failed(const std::size_t element) const
    {
      return erosion && erosion->is_failed(element);
    }
    EntityPlace where(const std::size_t element) const ///< its middle
    {
      Point3 x = Point3::Zero();
      for (const auto n : place.cells[element])
        x += (1. / n_corners) * Point3(place.records[n].position);
      return {"element", static_cast<std::uint64_t>(place.label[element]), {{x[0], x[1], x[2]}}};
    }
    bool is_owned(const std::size_t element) const
    {
      return lane(batches[element / n_lanes].owned, element % n_lanes) != 0.;
    }
    double sum(Lanes ElementChunk::*energy) const
    {
      double result = 0.;
      for (const ElementChunk &chunk : chunks)
        result += stdx::reduce(chunk.*energy);
      return result;
    }

    /// On the corners of a chunk's elements.
    void clear_forces(const std::size_t chunk)
    {
      constexpr std::size_t per_chunk = ElementBlocks::batches_per_chunk;
      for (std::size_t b = chunk * per_chunk; b < std::min(batches.size(), (chunk + 1) * per_chunk); ++b)
        for (const auto &of_corner : batches[b].corner)
          for (const std::uint32_t row : of_corner)
            place.corner_force[row] = {};
    }

    /// From now on bounds are those of these: bound(batch) in all lanes, at rest or in motion.
    template <class Bound>
    void update_bounds(const Bound &bound)
    {
      for (ElementChunk &chunk : chunks)
        chunk.bound = Lanes(0.);
      for (std::size_t b = 0; b < batches.size(); ++b)
        {
          batches[b].bound    = bound(b);
          ElementChunk &chunk = chunks[b / ElementBlocks::batches_per_chunk];
          chunk.bound         = larger(chunk.bound, Lanes(batches[b].owned * batches[b].bound));
        }
    }

    /// Of its `per_element` parts, in archives.
    std::vector<std::uint64_t> ids(const std::size_t per_element) const
    {
      std::vector<std::uint64_t> result;
      for (const std::uint64_t number : place.number)
        for (std::size_t k = 0; k < per_element; ++k)
          result.push_back(per_element * number + k);
      return result;
    }
    /// The element of a number in the mesh. @throws InputError where it is of another group.
    std::size_t find(const std::uint64_t number) const
    {
      const auto found = std::lower_bound(place.number.begin(), place.number.end(), number);
      if (found == place.number.end() || *found != number)
        throw InputError("The archive has points of element " + std::to_string(number) +
                         " in a section that it is not of: it was written of another case.");
      return static_cast<std::size_t>(found - place.number.begin());
    }
    ElementLane lane_of(Lanes &batch, const std::size_t element) const
    {
      return {batch, element, n_elements()};
    }

    /// The lane works on an element at rest from now on.
    void take_out(const std::size_t b, const std::size_t k)
    {
      erosion->batches[b].alive[k] = 0.;
      batches[b].inverse_mass[k]   = 0.; // no vote
      for (std::uint32_t i = 0; i < n_corners; ++i)
        batches[b].record[i][k] = static_cast<std::uint32_t>((place.n_nodes + i) * (sizeof(Record) / sizeof(double)));
    }

    /// What an update of the elements changes, of every kind.
    auto changing()
    {
      return std::tie(batches, chunks);
    }

    std::size_t bytes_of_group() const
    {
      return bytes_of(place.number) + bytes_of(place.cells) + bytes_of(place.record_cells) + bytes_of(mass) +
             bytes_of(batches) + bytes_of(chunks) + (erosion ? erosion->bytes() : 0);
    }

    Place                       place;
    std::vector<double>         mass; ///< [n_elements], kg
    AlignedVector<Batch>        batches;
    AlignedVector<ElementChunk> chunks;
    std::unique_ptr<Erosion_>   erosion; ///< null where the metal cannot fail
  };
} // namespace birdstrike
