#pragma once

#include <birdstrike/contact/contact.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace birdstrike::benchmarks
{
  /// Layers of points (2.5 mm apart) above a plate of 5 mm facets. Of the layers the first touches, the second is near
  /// (within the search margin), the others are not: `n_near` points in two layers, and `n_far_layers` beyond them.
  struct ContactWorkload
  {
    ContactWorkload(const std::size_t n_near, const std::size_t n_far_layers, const std::size_t n_threads)
      : pool(n_threads)
      , side(static_cast<std::size_t>(std::sqrt(0.5 * static_cast<double>(n_near))))
      , contact(ContactParameters())
    {
      add_points(2 + n_far_layers);
      add_plate(side / 2 + 12);
      // overlaps that the first call of all finds are remembered and push nothing
      for (const double approach : {-0.1, 0.1})
        {
          for (double &z : position[2])
            z += approach * spacing;
          search();
        }
    }

    std::size_t n_near() const
    {
      return 2 * side * side;
    }

    /// Facets within the search distance of a near point (offset of the surface and one spacing), mean: what a list
    /// with the default margin holds.
    double count_pairs() const;

    void compute_forces()
    {
      contact.add_forces(
        points(), facets(), step_size,
        {{{point_force[0].data(), point_force[1].data(), point_force[2].data()}}, {node_force.data(), 6}}, pool);
    }

    /// Points slide along the plate at 100 m/s: a list lasts some 30 steps, as in a strike.
    void slide()
    {
      for (double &x : position[0])
        x += 100. * step_size;
      ++n_slides;
      compute_forces();
    }

    /// To where the points were before they slid, 0.07 mm a step.
    void slide_back()
    {
      for (double &x : position[0])
        x -= 100. * step_size * static_cast<double>(n_slides);
      n_slides = 0;
      search();
    }

    /// A list from scratch and its forces.
    void search()
    {
      ++revision;
      compute_forces();
    }

    static constexpr double spacing = 2.5e-3, edge = 5e-3, half_thickness = 2.135e-3; ///< m
    static constexpr double step_size = 0.7e-6;                                       ///< s

    ThreadPool  pool;
    std::size_t side; ///< points along an edge of a layer
    Contact     contact;

  private:
    void       add_points(std::size_t n_layers);
    void       add_plate(std::size_t n);
    PointsView points() const;
    FacetsView facets() const;

    std::uint64_t                        revision = 1;
    std::size_t                          n_slides = 0;
    std::array<AlignedVector<double>, 3> position, velocity, point_force;
    AlignedVector<double>                mass, density, sound_speed;
    std::vector<std::uint32_t>           id;

    std::vector<double>                       node_position, node_velocity, node_force, inverse_mass, half_thicknesses;
    std::vector<std::array<std::uint32_t, 4>> facet;
    std::vector<std::array<std::int32_t, 4>>  neighbor;
  };
} // namespace birdstrike::benchmarks
