#include "structure/rigid_plate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace birdstrike::rigid_plate_test
{
  namespace
  {
    void push(RigidPlate &plate, const std::array<double, 3> &force)
    {
      const std::size_t n_nodes = plate.facets().n_nodes;
      const NodeForces  forces  = plate.clear_contact_forces();
      for (std::size_t n = 0; n < n_nodes; ++n)
        for (unsigned int d = 0; d < 3; ++d)
          forces.of(n)[d] += force[d] / n_nodes;
    }

    void advance(RigidPlate &plate, const std::array<double, 3> &force, const double dt, const unsigned int n_steps)
    {
      push(plate, force);
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          plate.kick_contact(0.5 * dt, HalfKick::first);
          plate.drift(dt);
          push(plate, force);
          plate.kick_contact(0.5 * dt, HalfKick::second);
        }
    }

    TEST(RigidPlate, IsTheRectangleAskedFor)
    {
      BladeParameters p;
      p.rigid.centre = {{1., 2., 3.}};
      p.rigid.normal = {{0., 3., 4.}};
      p.rigid.length = 0.2;
      p.rigid.width  = 0.1;
      RigidPlate plate(p);
      const auto facets = plate.facets();
      ASSERT_EQ(facets.n_facets, 1u);
      const auto node = [&](const unsigned int k) {
        const double *x = facets.position + 3 * facets.nodes[0][k];
        return Point3(x[0], x[1], x[2]);
      };
      const Point3 area = 0.5 * (node(2) - node(0)).cross(node(3) - node(1));
      EXPECT_LT((area - 0.02 * Point3(0., 0.6, 0.8)).norm(), 1e-15);
      EXPECT_LT((0.25 * (node(0) + node(1) + node(2) + node(3)) - Point3(1., 2., 3.)).norm(), 1e-14);
      EXPECT_NEAR((node(1) - node(0)).norm(), 0.2, 1e-15);
      EXPECT_TRUE(std::isinf(plate.mass()));
      EXPECT_TRUE(std::isinf(plate.step_limit().value));
    }

    TEST(RigidPlate, FixedOneTakesTheImpulse)
    {
      RigidPlate plate((BladeParameters()));
      advance(plate, {{1., 2., 3.}}, 1e-3, 100);
      const auto m = plate.momenta();
      EXPECT_NEAR(m.support_impulse[2], 0.3, 1e-14);
      EXPECT_NEAR(m.support_impulse[0], 0.1, 1e-14);
      EXPECT_EQ(m.momentum[2], 0.);
      EXPECT_EQ(plate.energies().contact_work, 0.);
      EXPECT_EQ(plate.tip_deflection().mid_chord, 0.);
    }

    // Constant force F on mass M: w = F t^2/(2M), exact for velocity-Verlet; the guide takes the rest.
    TEST(RigidPlate, FreeOneMovesAlongItsNormal)
    {
      BladeParameters p;
      p.rigid.motion = RigidMotion::free_along_normal;
      p.rigid.mass   = 0.5;
      RigidPlate plate(p);
      advance(plate, {{1., 0., 3.}}, 1e-3, 100);
      EXPECT_NEAR(plate.speed(), 0.6, 1e-14);
      EXPECT_NEAR(plate.tip_deflection().mid_chord, 0.03, 1e-15);
      EXPECT_NEAR(plate.facets().position[2], 0.03, 1e-15);
      EXPECT_NEAR(plate.facets().velocity[2], 0.6, 1e-14);
      const auto m = plate.momenta();
      EXPECT_NEAR(m.momentum[2] + m.support_impulse[2], m.contact_impulse[2], 1e-15);
      EXPECT_NEAR(m.support_impulse[0], 0.1, 1e-14);
      // a constant force: kinetic energy of whole steps is the sum of the works, what staggers is the same at the start
      const auto energy = plate.energies();
      EXPECT_NEAR(energy.kinetic - energy.contact_work, 0., 1e-15);
      EXPECT_NEAR(energy.staggering, 0., 1e-15);
    }

    TEST(RigidPlate, TakesTheFacetsOfAMesh)
    {
      BladeParameters p;
      p.rigid.surface = RigidSurface::mesh;
      p.mesh.n_span   = 4;
      p.mesh.n_chord  = 3;
      RigidPlate plate(p);
      EXPECT_EQ(plate.n_elements(), 12u);
      EXPECT_EQ(plate.facets().n_facets, 12u);
      EXPECT_EQ(plate.snapshot().points.size(), 3 * plate.n_nodes());
      EXPECT_NEAR(plate.census().area, 0.3112 * 0.0889, 1e-15);
    }
  } // namespace
} // namespace birdstrike::rigid_plate_test
