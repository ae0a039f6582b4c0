#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/implementation.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <functional>
#include <string>

namespace birdstrike
{
  SolidElements::SolidElements(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 8>> cells,
                               const SolidSection &section, ThreadPool &pool)
    : implementation(std::make_unique<Implementation>(std::move(nodes), std::move(cells), section, pool))
  {
  }
  SolidElements::~SolidElements()                         = default;
  SolidElements::SolidElements(SolidElements &&) noexcept = default;

  void SolidElements::compute_internal_forces(const double *position, const double *increment, const double dt,
                                              double *force)
  {
    Implementation       &my                 = *implementation;
    constexpr std::size_t elements_per_chunk = Implementation::batches_per_chunk * n_lanes;
    static_assert(Implementation::elements_per_block % elements_per_chunk == 0, "a block has whole chunks");
    for (const auto &block : my.blocks.blocks)
      {
        my.update_nodes(block, position, increment);
        const std::size_t first = block.element_begin / elements_per_chunk;
        const std::size_t n_chunks =
          (block.element_end - block.element_begin + elements_per_chunk - 1) / elements_per_chunk;
        const auto body = [&](const std::size_t begin, const std::size_t end) {
          for (std::size_t c = begin; c < end; ++c)
            my.update_chunk(first + c, dt);
        };
        my.pool.parallel_for(n_chunks, 1, std::cref(body));
        my.gather_forces(block, force);
      }
    if (my.erosion)
      my.erode();
  }

  double SolidElements::largest_stable_step() const
  {
    Lanes largest = 0.;
    for (const auto &chunk : implementation->chunks)
      largest = max(largest, chunk.frequency);
    return 2. / stdx::hmax(largest);
  }

  StepLimit SolidElements::step_limit() const
  {
    const Implementation &my      = *implementation;
    double                largest = 0.;
    std::size_t           worst   = 0;
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      if (const double value = lane(my.batches[e / n_lanes].frequency, e % n_lanes); value > largest)
        {
          largest = value;
          worst   = e;
        }
    return {2. / largest, "solid element, largest eigenvalue", my.place(worst)};
  }

  void SolidElements::use_nodal_masses(const std::span<const double> mass)
  {
    if (mass.size() != implementation->n_nodes)
      throw InputError("Solid elements: " + std::to_string(mass.size()) + " nodal masses for " +
                       std::to_string(implementation->n_nodes) + " nodes.");
    implementation->set_inverse_masses(mass);
  }

  std::vector<double> SolidElements::compute_nodal_masses() const
  {
    const Implementation &my = *implementation;
    std::vector<double>   mass(my.n_nodes, 0.);
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      for (const auto n : my.cells[e])
        mass[n] += 0.125 * my.mass[e];
    return mass;
  }

  double SolidElements::Implementation::sum(Lanes Chunk::*energy) const
  {
    double result = 0.;
    for (const Chunk &chunk : chunks)
      result += stdx::reduce(chunk.*energy);
    return result;
  }

  std::size_t SolidElements::n_elements() const
  {
    return implementation->cells.size();
  }

  std::size_t SolidElements::n_promoted() const
  {
    const Implementation &my = *implementation;
    if (my.section.formulation != SolidFormulation::solid_shell)
      return n_elements();
    std::size_t n = 0;
    for (std::size_t e = 0; e < n_elements(); ++e)
      n += !my.layers[e / n_lanes].empty();
    return n;
  }

  namespace
  {
    template <class Vector>
    std::size_t bytes_of(const Vector &v)
    {
      return v.capacity() * sizeof(typename Vector::value_type);
    }
  } // namespace

  std::size_t SolidElements::bytes() const
  {
    const Implementation &my     = *implementation;
    std::size_t           layers = bytes_of(my.layers) + bytes_of(my.thickness_axis);
    for (const auto &points : my.layers)
      layers += bytes_of(points);
    return layers + bytes_of(my.cells) + my.blocks.bytes() + bytes_of(my.mass) + bytes_of(my.work_begin) +
           bytes_of(my.records) + bytes_of(my.corner_force) + bytes_of(my.node_force) + bytes_of(my.work) +
           bytes_of(my.batches) + bytes_of(my.mass_factors) + bytes_of(my.chunks) + bytes_of(my.points) +
           bytes_of(my.stabilisation) + (my.erosion ? my.erosion->bytes() : 0);
  }
} // namespace birdstrike
