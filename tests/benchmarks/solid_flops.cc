#include "counted_number.h"
#include "flops.h"

#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/layers.h"
#include "structure/elements/solid/step_bound.h"

/// The templates of the solid elements, run with a number that counts; rules: flops.h.
namespace birdstrike::benchmarks
{
  namespace
  {
    using Corners = Vector3<Counted>[8];

    struct Element
    {
      SolidPoint<Counted>                     points[8];
      one_point_solid::Stabilisation<Counted> stabilisation;
      solid_shell::LayerPoint<Counted>        layers[5];
      ThicknessPoints                         rule = make_thickness_points(ThicknessRule::gauss, 5);
      Corners                                 position, increment;

      Element(const SolidLaw &law, const double strain)
      {
        for (auto &point : points)
          {
            for (auto &s : point.stress)
              s = 0.;
            point.plastic_strain = point.plastic_work = 0.;
            point.yield                               = law.initial_yield();
          }
        solid_shell::Layers<Counted>{law, rule}.promote(layers);
        for (int k = 0; k < 3; ++k)
          stabilisation.last[k] = stabilisation.linear[k][0] = stabilisation.linear[k][1] = stabilisation.linear[k][2] =
            0.;
        for (int i = 0; i < 8; ++i)
          {
            const double x = 2e-3 * (i & 1), y = 2e-3 * (i >> 1 & 1), z = 2e-3 * (i >> 2);
            position[i]  = {x + 0.1 * y, y, z + 0.05 * x};
            increment[i] = {strain * x * (1. + 300. * (z - 1e-3)), 0., 0.};
          }
      }

      /// In the order of the loops (source/structure/elements/solid/loops.cc).
      void step(const SolidLaw &law, const SolidFormulation formulation, const bool is_plastic)
      {
        const SolidModes<Counted>    x(position), u(increment), middle = compute_midpoint_modes(x, u);
        const SolidGeometry<Counted> midpoint(middle), end(x);
        const Matrix3<Counted>       gradient = midpoint.compute_mean_gradient(u);
        const Counted                trace    = gradient(0, 0) + gradient(1, 1) + gradient(2, 2);
        Counted                      drag;
        law.compute_viscous_pressure(Counted(trace * 3e6), midpoint.compute_height(), drag);
        SolidModes<Counted> force;
        if (formulation == SolidFormulation::b_bar)
          {
            for (int k = 0; k < 3; ++k)
              force.linear[k] = force.twist[k] = force.last = Vector3<Counted>::Constant(Counted(0.));
            Counted pressure = 0.;
            for (int p = 0; p < b_bar_solid::n_points; ++p)
              {
                using namespace b_bar_solid;
                const Jacobian<Counted> at_midpoint(Derivatives<Counted>(middle, p)),
                  at_end(Derivatives<Counted>(x, p));
                law.update_point(at_midpoint.compute_gradient(Derivatives<Counted>(u, p), trace), 0.3e-6, points[p]);
                const Counted stretch = Counted(3.) / at_end.det;
                add_point_forces(at_end, at_end.det, stretch, points[p].stress, p, force, pressure);
              }
            end.add_mean_forces(Vector3<Counted>::Constant(pressure).asDiagonal(), force);
          }
        else
          {
            const one_point_solid::Axes<Counted> axes(middle);
            const auto                           strain = one_point_solid::compute_strains(middle, axes, gradient, u);
            if (formulation == SolidFormulation::one_point)
              law.update_one_point(gradient, strain, 0.3e-6, points[0], stabilisation);
            else
              update_section(law, gradient, strain, x, is_plastic);
            const Counted inverse_ratio = end.det * end.inverse_det;
            for (auto &s : points[0].stress)
              s = inverse_ratio * s;
            force = one_point_solid::compute_mode_forces(end, end.det, points[0].stress, stabilisation);
          }
        Corners corner;
        force.sum_at_corners(corner);
        compute_frequency_bound(end, end.det, Counted(1. / 3.5e-8), drag, law, formulation);
      }

      void update_section(const SolidLaw &law, const Matrix3<Counted> &gradient,
                          const one_point_solid::Stabilisation<Counted> &strain, const SolidModes<Counted> &end,
                          const bool is_plastic)
      {
        using namespace solid_shell;
        points[0].rotate_and_strain(law.elasticity, gradient);
        compute_varying_work(stabilisation, strain);
        add_stress(law.elasticity, strain, stabilisation);
        Squares<Counted>(stabilisation).compute_bound(von_mises_squared(points[0].stress));
        if (is_plastic)
          Layers<Counted>{law, rule}.update(end, one_point_solid::Axes<Counted>(end), 0.3e-6, true, points[0],
                                            stabilisation, layers);
        compute_varying_work(stabilisation, strain);
      }
    };
  } // namespace

  Work solid_work(const SolidFormulation formulation, const bool is_plastic)
  {
    SolidSection section;
    section.material.hardening.law     = HardeningLaw::linear;
    section.material.hardening.modulus = 1.25e9;
    const SolidLaw law(section);
    Element        element(law, is_plastic ? 1e-3 : 1e-6);
    for (int k = 0; k < 20; ++k)
      element.step(law, formulation, is_plastic);
    const double flops = count_flops([&] { element.step(law, formulation, is_plastic); });
    // viscous pressure and energies 20; a node an element: sum of eight corners' forces 24, work 9
    constexpr double elsewhere = 20. + 24. + 9.;
    // a node: position, increment, force (9), record written and read (2 x 8), last force (2 x 4); an element: corner
    // forces written and read (2 x 32), mass, bound, viscous pressure (4), its nodes (8); a point: 2 x 9, stabilisation
    // 2 x 12, a point through the thickness 2 x 8
    const double layers  = formulation == SolidFormulation::solid_shell && is_plastic ? 5. * 16. : 0.;
    const double points  = formulation == SolidFormulation::b_bar ? 8. * 18. : 18. + 24. + layers;
    const double doubles = 9. + 16. + 8. + 64. + 4. + 8. + points;
    return {flops + elsewhere, 8. * doubles};
  }
} // namespace birdstrike::benchmarks
