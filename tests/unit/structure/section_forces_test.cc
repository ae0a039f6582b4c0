#include "blade_case.h"
#include "structure/deformable_blade.h"
#include "structure/histories/section_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Force and moment through sections across the span, against statics and dynamics.
namespace birdstrike::section_forces_test
{
  namespace
  {
    constexpr double length = 0.3112, chord = 0.0889, thickness = 0.00427, density = 4430., young = 113.8e9;

    BladeRoles roles_of(const auto &mesh)
    {
      return BladeRoles(mesh, {0}, {1}, {});
    }

    /// Free in the plane, without lateral strain.
    BladeParameters bar(const bool is_free)
    {
      BladeParameters p  = is_free ? test::free_plate(28, 4) : test::elastic_plate(28, 4);
      p.material.poisson = "0";
      return p;
    }

    template <class AnyBlade, class Mesh>
    SectionForces forces_at(AnyBlade &blade, const Mesh &mesh, const double station)
    {
      constexpr int dim   = Mesh::n_corners == 4 ? 2 : 3;
      const auto    nodes = blade.nodes();
      return SectionCut<dim>(mesh, roles_of(mesh), station, SymmetryPlane(mesh.symmetry_nodes.size() > 0))
        .compute(nodes.force, nodes.position);
    }

    /// Loads of 10 N in all along z and 3 N along y at the tip, and rest after critical damping: e^-16 of the motion is
    /// left. It deflects by 1.5 mm.
    template <class AnyBlade>
    void expect_statics(const BladeKind kind)
    {
      BladeParameters p   = bar(false);
      p.kind              = kind;
      p.loads.damping     = 460.; // 1/s, twice the first angular frequency
      const bool is_solid = kind == BladeKind::solid;
      for (int k = 0; k <= 4; ++k)
        for (const double z :
             is_solid ? std::vector<double>{-0.5 * thickness, 0.5 * thickness} : std::vector<double>{0.})
          {
            const double share = (k % 4 == 0 ? 0.125 : 0.25) / (is_solid ? 2. : 1.);
            p.loads.point_loads += (p.loads.point_loads.empty() ? "" : " | ") + std::to_string(length) + " " +
                                   std::to_string(chord * (0.25 * k - 0.5)) + " " + std::to_string(z) + ": 0; " +
                                   std::to_string(3. * share) + "; " + std::to_string(10. * share);
          }
      ThreadPool   pool;
      AnyBlade     blade(p, pool);
      const double dt = 0.9 * blade.largest_stable_step();
      test::advance(blade, dt, static_cast<unsigned int>(0.07 / dt));
      const typename std::conditional_t<std::is_same_v<AnyBlade, ShellBlade>, ShellMesh, SolidMesh> mesh(p);
      for (const double station : {0.25, 0.5, 0.75})
        {
          const SectionForces now = forces_at(blade, mesh, station);
          const double        arm = (1. - station) * length, x = station * length;
          const double        EI    = young * chord * std::pow(thickness, 3) / 12.;
          const double        slope = 10. * (length * x - 0.5 * x * x) / EI;
          const double rise = 10. * std::pow(length, 3) / (3. * EI) - 10. * x * x * (3. * length - x) / (6. * EI);
          // shear in both directions is the load, moments load times arm; the bent blade's own shortening: 1e-6
          EXPECT_NEAR(now.force[2], 10., 1e-4);
          EXPECT_NEAR(now.force[1], 3., 1e-4);
          // of second order, by 1 %: the axes have turned by the slope, the side load lies above the section
          EXPECT_NEAR(now.normal(), 10. * slope, 0.1 * slope);
          EXPECT_NEAR(now.bending(), 10. * arm, 1e-4 * 10. * length);
          EXPECT_NEAR(now.moment[2], 3. * arm, 1e-4 * 3. * length);
          EXPECT_NEAR(now.moment[0], -3. * rise, 0.03 * rise);
        }
      // the root is station 0: there from the root's own nodes
      const SectionForces     at_root = forces_at(blade, mesh, 0.);
      const RootSectionReport root    = blade.root_section();
      EXPECT_NEAR(at_root.bending(), root.bending_moment, 1e-9 * root.bending_moment);
      EXPECT_NEAR(at_root.force[2], root.transverse_force, 1e-9 * 10.);
      EXPECT_NEAR(at_root.normal(), root.normal_force, 1e-9 * 10.);
    }

    TEST(SectionForces, OfACantileverAreLoadAndArm)
    {
      expect_statics<ShellBlade>(BladeKind::shell);
      expect_statics<SolidBlade>(BladeKind::solid);
    }

    // A bar that spins freely about its middle: N(s) = rho A omega^2 ((L/2)^2 - s^2)/2. It starts unstretched and so
    // vibrates about that, by modes of whole multiples of c/(2 L): the mean over periods 2 L/c is the steady force.
    // What is left are the dispersion of 28 elements and the stretch: 0.5 %. The axes turn with the bar, by 0.5 rad;
    // Coriolis' force on the stretching bar bends it by less than 1e-3.
    TEST(SectionForces, OfASpinningBarCarryItsCentrifugalForce)
    {
      const double    omega = 400., period = 2. * length / std::sqrt(young / density);
      BladeParameters p    = bar(true);
      p.loads.initial_spin = "0; 0; " + std::to_string(omega);
      const ShellMesh mesh(p);
      for (const double station : {0.5, 0.25})
        {
          ThreadPool   pool;
          ShellBlade   blade(p, pool);
          const auto   n_period = static_cast<unsigned int>(std::ceil(period / (0.9 * blade.largest_stable_step())));
          const double dt       = period / n_period;
          const SectionCut<2> cut(mesh, roles_of(mesh), station, SymmetryPlane());
          double              sum = 0.;
          for (unsigned int step = 1; step <= 10 * n_period; ++step)
            {
              test::advance(blade, dt, 1);
              const auto nodes = blade.nodes();
              const auto now   = cut.compute(nodes.force, nodes.position);
              sum += now.normal() / (10. * n_period);
              EXPECT_NEAR(now.axes(0, 1), std::sin(omega * step * dt), 1e-3);
            }
          const double s = (station - 0.5) * length;
          const double N = 0.5 * density * chord * thickness * omega * omega * (0.25 * length * length - s * s);
          EXPECT_NEAR(sum / N, 1., 5e-3);
        }
    }

    // Newton's law for what lies beyond the cut, step by step: the momentum of leapfrog changes by the mean of the
    // forces at both ends of the step, here those through the section and a bird's push. To round-off.
    template <class AnyBlade>
    void expect_newton(const BladeKind kind, const bool is_halved)
    {
      BladeParameters p        = bar(false);
      p.kind                   = kind;
      p.is_halved              = is_halved;
      p.loads.initial_velocity = "0; 0; 50*(x/0.3112)^2";
      ThreadPool                                                                                    pool;
      AnyBlade                                                                                      blade(p, pool);
      const typename std::conditional_t<std::is_same_v<AnyBlade, ShellBlade>, ShellMesh, SolidMesh> mesh(p);
      const auto    nodes = blade.nodes();
      const double  dt = 0.9 * blade.largest_stable_step(), push = 3000.; // N, on a node
      std::uint32_t struck = 0;
      for (std::uint32_t n = 0; n < nodes.n; ++n)
        if (std::abs(nodes.reference[3 * n] - 0.75 * length) < 1e-3 && nodes.reference[3 * n + 1] > 0.4 * chord)
          struck = n;
      const auto momentum = [&](const double from) {
        Point3 sum = Point3::Zero();
        for (std::size_t n = 0; n < nodes.n; ++n)
          if (nodes.reference[3 * n] > from - 1e-6)
            sum += (nodes.reference[3 * n] > from + 1e-6 ? 1. : 0.5) * nodes.mass[nodes.n_unknowns * n] *
                   Point3(nodes.velocity + nodes.n_unknowns * n);
        return is_halved ? Point3(2. * sum[0], 0., 2. * sum[2]) : sum;
      };
      const double station = 0.5, from = station * length; // half of the row of nodes there belongs to what is beyond
      Point3       force = -forces_at(blade, mesh, station).force, before = momentum(from);
      double       largest = 0.;
      blade.compute_internal_forces();
      force = -forces_at(blade, mesh, station).force;
      for (unsigned int step = 0; step < 200; ++step)
        {
          const double half = 0.5 * dt;
          blade.kick_contact(half, HalfKick::first);
          blade.kick_internal(half, HalfKick::first);
          blade.drift(dt);
          blade.compute_internal_forces();
          blade.clear_contact_forces().of(struck)[2] = push;
          blade.kick_internal(half, HalfKick::second);
          blade.kick_contact(half, HalfKick::second);
          const Point3 pushed(0., 0., is_halved ? 2. * push : push);
          const Point3 now = pushed - forces_at(blade, mesh, station).force, after = momentum(from);
          const Point3 error = (after - before) / dt - 0.5 * (force + now);
          largest            = std::max(largest, now.norm());
          if (step > 0)
            {
              EXPECT_LT(error.norm(), 1e-8 * largest) << step;
            }
          force  = now;
          before = after;
        }
      EXPECT_GT(largest, 100.);
    }

    TEST(SectionForces, ChangeTheMomentumOfWhatLiesBeyond)
    {
      expect_newton<ShellBlade>(BladeKind::shell, false);
      expect_newton<SolidBlade>(BladeKind::solid, false);
      expect_newton<ShellBlade>(BladeKind::shell, true);
    }
  } // namespace
} // namespace birdstrike::section_forces_test
