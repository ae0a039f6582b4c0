#include "structure/elements/solid/group.h"

#include <algorithm>
#include <limits>

// What keeps the corners of bricks from turning inside out (corner_volume.h).
namespace birdstrike
{
  SolidModes<Lanes> SolidGroup::modes_of_batch(const std::size_t b) const
  {
    Vector3<Lanes> x[8];
    for (std::size_t k = 0; k < n_lanes; ++k)
      for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c)
          x[i][c][k] = place.records[place.cells[element_of(b * n_lanes + k)][i]].position[c];
    return SolidModes<Lanes>(x);
  }

  void SolidGroup::build_corners()
  {
    for (std::size_t b = 0; b < batches.size(); ++b)
      {
        const SolidModes<Lanes>    modes = modes_of_batch(b);
        const SolidGeometry<Lanes> geometry(modes);
        corner_shares.emplace_back(geometry);
        const Lanes largest = corner_shares.back().largest();
        for (std::size_t k = 0; k < n_lanes; ++k)
          batches[b].undistorted[k] = corner_volume::undistorted(largest[k]);
        batches[b].corner_energy = 0.;
      }
  }

  corner_volume::Shares<Lanes> SolidGroup::shares_at_rest(const std::size_t b) const
  {
    corner_volume::Shares<Lanes> rest = corner_shares[b];
    if (erosion) // what has failed, or does in this step, is an element at rest
      for (Lanes &share : rest.of)
        share = select(erosion->batches[b].alive > erosion->elements[b].inverted, share, Lanes(0.));
    return rest;
  }

  corner_volume::Pressure<Lanes> SolidGroup::corner_pressure(const std::size_t           b,
                                                             const SolidGeometry<Lanes> &geometry) const
  {
    const double modulus = law.elasticity.bulk_modulus();
    return {geometry, shares_at_rest(b), Lanes(modulus / 512. * batches[b].rest_det)};
  }

  [[gnu::noinline]] SolidModes<Lanes> SolidGroup::hold_corners(const std::size_t b, const SolidModes<Lanes> &end,
                                                               const SolidModes<Lanes> &u, const double dt)
  {
    Batch                               &batch = batches[b];
    const SolidGeometry<Lanes>           geometry(end);
    const corner_volume::Pressure<Lanes> pressure = corner_pressure(b, geometry);
    batch.corner_energy                           = pressure.energy;
    const corner_volume::Shares<Lanes> rest       = shares_at_rest(b);
    // no corner loses more than half of its share in the next step
    const Lanes least = max(batch.bound, Lanes(4. / dt * corner_volume::largest_loss(geometry, u, rest)));
    const Lanes squared =
      8. * batch.inverse_mass * pressure.stiffness(geometry, Lanes(2. / (dt * least)), u, rest); // 1/s^2
    batch.bound = max(least, Lanes(0.5 * (batch.bound + sqrt(batch.bound * batch.bound + 4. * squared))));
    return pressure.force;
  }

  void SolidGroup::take_up_positions()
  {
    for (std::size_t b = 0; b < batches.size(); ++b)
      {
        const SolidModes<Lanes> modes = modes_of_batch(b);
        batches[b].corner_energy      = corner_pressure(b, SolidGeometry<Lanes>(modes)).energy;
      }
  }

  double SolidGroup::smallest_corner(const std::size_t element) const
  {
    const SolidModes<double>            x = modes(element);
    const SolidGeometry<double>         g(x);
    const corner_volume::Shares<double> shares(g);
    double                              smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i)
      if (corner_shares[element / n_lanes].of[i][element % n_lanes] > 0.)
        smallest = std::min(smallest, shares.of[i] * g.volume());
    return smallest;
  }
} // namespace birdstrike
