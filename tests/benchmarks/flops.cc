#include "flops.h"

#include "counted_number.h"

#include "contact/law.h"
#include "structure/elements/shell/full_integration.h"
#include "structure/elements/shell/kernel.h"
#include "structure/elements/shell/section.h"
#include "structure/elements/shell/step_bound.h"
#include <birdstrike/bird/particles.h>
#include <birdstrike/core/closest_point.h>

/// Where a formula is a template on the number type it is run with a number that counts; where a loop is written in
/// SIMD registers (pairs of particles, nodal loops) the operations are counted by hand, line by line, and stand here
/// with what they belong to. After a change of such a loop its line here changes with it.
namespace birdstrike::benchmarks
{
  // ---- bird ----

  Work pair_loop_work(const double n_true_neighbors)
  {
    // RiemannRates::sum_neighbors, corrected, no reconstruction, float pairs; pairs beyond the support are computed too
    // but are no work. Every fourth pass adds the moments (12) and the smallest volume (1).
    constexpr double separation = 3. + 3. + 6.;            // x, v, r^2 with its smallest distance
    constexpr double kernel     = 5. + 1. + 2. + 4.;       // 1/r by one Newton step, r, 1 - r, w
    constexpr double solver     = 5. + 2. + 7. + 1.;       // v.x, u, q, approach
    constexpr double stress     = 9. + 15. + 6.;           // p_i B_i + p_j B_j + q, times w x, converted and added
    constexpr double sums       = 3. + 18. + 6. + 3. + 1.; // w x, gradient, flux, heat, weight
    constexpr double renewal    = 13. / 4.;
    constexpr double per_pair   = separation + kernel + solver + stress + sums + renewal;
    // store_rates: gradient 9, divergence 11, rates 13, power 8, force 3, prediction 2 x 20; a fourth of B from moments
    // 55; the error of the prediction 16; update_records: pressure and sound speed 2 x 20 + 7, rho, V, solid, p B, Z,
    // 1/Z 13, bounds 15
    constexpr double per_particle = 9. + 11. + 13. + 8. + 3. + 40. + 14. + 16. + 47. + 13. + 15.;
    // update_records reads x, v, force, contact force (12), mu, rate (2), B (3), writes density, volume, sound speed
    // (3) and a record (8); store_rates reads the record, v, both forces, mu, rate, B, sound speed (8 + 9 + 2 + 3 + 1)
    // and the predicting forces and rate (4), and writes force, two rates, signal speed, error (7), every fourth time B
    // and the largest mu (1); the list at 4 bytes
    constexpr double doubles = 12. + 2. + 3. + 3. + 8. + 23. + 4. + 7. + 1.;
    return {per_pair * n_true_neighbors + per_particle, 8. * doubles + 4. * n_true_neighbors};
  }

  Work particle_motion_work()
  {
    // Bird::kick: velocity 3 x 3, power 3 x 2, energy 2, compress 11. Reads v, f, f_c (9), power, rate (2), e, mu (2);
    // writes v (3), e, mu (2)
    return {9. + 6. + 2. + 11., 8. * (9. + 2. + 2. + 3. + 2.)};
  }

  Work particle_step_work(const double n_true_neighbors)
  {
    // two kicks; Bird::drift: 3 x 2 flops, x read and written, v read; its check: 15 flops, x and start (float) read
    const Work       pairs = pair_loop_work(n_true_neighbors), kick = particle_motion_work();
    constexpr double drift_flops = 6. + 15., drift_doubles = 9. + 4.5;
    return {pairs.flops + 2. * kick.flops + drift_flops, pairs.bytes + 2. * kick.bytes + 8. * drift_doubles};
  }

  // ---- shell ----

  namespace
  {
    using Vectors = Vector3<Counted>[4];

    void set_plate(Vectors &position, Vectors &normal, Vectors &increment, Vectors &rotation, const double strain)
    {
      const double xi[4] = {-1., 1., 1., -1.}, eta[4] = {-1., -1., 1., 1.}, half = 2.5e-3;
      for (int i = 0; i < 4; ++i)
        {
          const double x = half * xi[i], y = half * eta[i];
          position[i]  = {x, y, 1e-5 * xi[i] * eta[i]};
          normal[i]    = {1e-3 * xi[i], 1e-3 * eta[i], 1.};
          increment[i] = {strain * x, 0., 0.};
          rotation[i]  = {0., -150. * strain * x, 0.};
        }
    }

    /// One element-step of the default formulation, in the order of the loop over batches
    /// (source/structure/elements/shell/loops.cc).
    void step_element(const ShellSectionLaw &law, ShellStress<Counted> &stress, ShellPoint<Counted> *points,
                      const double strain)
    {
      Vectors position, normal, increment, rotation, director;
      set_plate(position, normal, increment, rotation, strain);
      const auto    x = ShellModes<Counted>::of_corners(position), u = ShellModes<Counted>::of_corners(increment);
      const Counted half = 0.5;
      const auto    midpoint =
        ShellGeometry<Counted>::of_modes({x.m0, x.m1 - half * u.m1, x.m2 - half * u.m2, x.m3 - half * u.m3}, normal);
      for (int i = 0; i < 4; ++i)
        director[i] = rotation[i].cross(midpoint.director[i]);
      const auto strains = physical_shell::compute_strains(midpoint, u, ShellModes<Counted>::of_corners(director));
      ShellWork<Counted> work;
      if (points == nullptr)
        law.update_elastic(strains, 880e6, stress, work);
      else
        law.update_plastic(strains, 0.7e-6, stress, points);
      const auto          end = ShellGeometry<Counted>::of_modes(x, normal);
      ShellModes<Counted> f, fd;
      Vectors             force, moment;
      physical_shell::compute_mode_forces(end, compute_resultants(stress, law.contraction(stress)), f, fd);
      f.sum_at_corners(force);
      fd.sum_at_corners(director);
      for (int i = 0; i < 4; ++i)
        moment[i] = end.director[i].cross(director[i]);
      compute_eigenvalue_bound<false>(end, stress.thickness, Counted(1. / 4.7e-4), Counted(3.1e-6), law);
    }

    /// The same fully integrated (source/structure/elements/shell/full_integration.cc); points of one section after the
    /// other.
    void step_fully_integrated(const ShellSectionLaw &law, SectionStress<Counted> (&stress)[4],
                               ShellPoint<Counted> *points, const double strain)
    {
      Vectors position, normal, increment, rotation, director;
      set_plate(position, normal, increment, rotation, strain);
      const auto    x = ShellModes<Counted>::of_corners(position), u = ShellModes<Counted>::of_corners(increment);
      const Counted half = 0.5;
      const auto    midpoint =
        ShellGeometry<Counted>::of_modes({x.m0, x.m1 - half * u.m1, x.m2 - half * u.m2, x.m3 - half * u.m3}, normal);
      for (int i = 0; i < 4; ++i)
        director[i] = rotation[i].cross(midpoint.director[i]);
      const double                             nu = law.elasticity.poisson;
      full_integration::PlaneGeometry<Counted> plane(midpoint, nu);
      SectionVector<Counted>                   section[4];
      compute_point_strains(plane, full_integration::DirectorGradient<Counted>(midpoint),
                            full_integration::compute_strains(midpoint, u, ShellModes<Counted>::of_corners(director)),
                            section);
      for (unsigned int k = 0; k < 4; ++k)
        {
          if (points == nullptr)
            law.update_elastic(section[k], 880e6, stress[k]);
          else
            law.update_plastic(section[k], 0.7e-6, stress[k], points + k * law.rule.n);
          section[k] = compute_resultants(stress[k], law.contraction(stress[k]));
        }
      const auto end = ShellGeometry<Counted>::of_modes(x, normal);
      plane          = full_integration::PlaneGeometry<Counted>(end, nu);
      ShellModes<Counted> f, fd;
      Vectors             force, moment;
      full_integration::compute_mode_forces(
        end, integrate_resultants(plane, full_integration::DirectorGradient<Counted>(end), section), f, fd);
      f.sum_at_corners(force);
      fd.sum_at_corners(director);
      for (int i = 0; i < 4; ++i)
        moment[i] = end.director[i].cross(director[i]);
      compute_eigenvalue_bound<true>(end, stress[0].thickness, Counted(1. / 4.7e-4), Counted(3.1e-6), law);
    }

    ShellSectionLaw make_law(const unsigned int n_points)
    {
      ShellSection section;
      section.n_points                   = n_points;
      section.material.hardening.law     = HardeningLaw::linear;
      section.material.hardening.modulus = 1.25e9;
      return ShellSectionLaw(section);
    }

    /// An element with so many sections in its plane, of so many numbers each, from the flops of its step.
    Work make_shell_work(const double flops, const double n_sections, const double n_numbers, const double n_points)
    {
      // work of the corner forces 4 x 6 x 3 and its booking 6; a node an element: normal from four corners 4 x 18 + 15,
      // sum of four corners' forces 24
      constexpr double elsewhere = 72. + 6. + 87. + 24.;
      // a node: position, increment, force (15), record written and read (2 x 16); an element: corner forces written,
      // read and gathered (3 x 24), mass, area, bound, works (9), its nodes (2), stress (2 x); a point: 2 x 6
      const double doubles = 15. + 32. + 72. + 9. + 2. + n_sections * (2. * n_numbers + 12. * n_points);
      return {flops + elsewhere, 8. * doubles};
    }
  } // namespace

  Work shell_work(const bool is_plastic, const unsigned int n_points)
  {
    const ShellSectionLaw law = make_law(n_points);
    ShellStress<Counted>  stress{};
    ShellPoint<Counted>   points[7];
    stress.thickness = 4.27e-3;
    if (is_plastic)
      {
        law.promote(stress, points);
        for (int k = 0; k < 20; ++k)
          step_element(law, stress, points, 1e-3);
      }
    const double flops = count_flops([&] { step_element(law, stress, is_plastic ? points : nullptr, 2e-5); });
    return make_shell_work(flops, 1., 15., is_plastic ? n_points : 0.);
  }

  Work full_shell_work(const bool is_plastic, const unsigned int n_points)
  {
    const ShellSectionLaw  law = make_law(n_points);
    SectionStress<Counted> stress[4]{};
    ShellPoint<Counted>    points[4 * 7];
    for (unsigned int k = 0; k < 4; ++k)
      stress[k].thickness = 4.27e-3;
    if (is_plastic)
      {
        for (unsigned int k = 0; k < 4; ++k)
          law.promote(stress[k], points + k * n_points);
        for (int k = 0; k < 20; ++k)
          step_fully_integrated(law, stress, points, 1e-3);
      }
    const double flops = count_flops([&] { step_fully_integrated(law, stress, is_plastic ? points : nullptr, 2e-5); });
    return make_shell_work(flops, 4., 9., is_plastic ? n_points : 0.);
  }

  // ---- contact ----

  Work contact_work(const double n_pairs)
  {
    const std::array<Vector3<Counted>, 4> x       = {Vector3<Counted>(0., 0., 0.), Vector3<Counted>(5e-3, 0., 0.),
                                                     Vector3<Counted>(5e-3, 5e-3, 0.), Vector3<Counted>(0., 5e-3, 0.)};
    const double                          closest = count_flops([&] {
      compute_closest_point(Vector3<Counted>(1e-3, 2e-3, 3e-3), x);
      const auto normal = compute_area_vector(x);
      sqrt(normal.dot(normal));
    });
    Touch<Counted> touch{1e-4, 2.5e-3, 1e9, 2.67, 1000., 1100., 1e-5, {0., 0., 1.}, {100., 0., -10.}};
    const double   force = count_flops([&] {
      compute_contact_force(ContactLaw{1., 1., 0., 2., 0.7e-6}, touch);
      compute_reduced_mass(Counted(1e-5), std::array<Counted, 4>{.1, .2, .3, .4},
                             std::array<Counted, 4>{1., 1., 1., 1.});
    });
    // a pair: distance and unit normal 4; a near point: gap 24 + 8, travel 6, overlap 3, direction 4; a touch (every
    // second near point): relative velocity 24, shares of the nodes 4 x 6, sums 8
    const double flops = n_pairs * (closest + 4.) + 45. + 0.5 * (force + 24. + 24. + 8.);
    // a pair: indices (1), offset, normal, distance, weights written and read (2 x 11); a near point: position,
    // velocity (6), record (2 x 10), slots (2 x 12); a touch: mass, density, sound speed, force (3 + 2 x 3), nodes'
    // share
    const double doubles = n_pairs * 23. + 50. + 0.5 * 9. + 4.;
    return {flops, 8. * doubles};
  }
} // namespace birdstrike::benchmarks
