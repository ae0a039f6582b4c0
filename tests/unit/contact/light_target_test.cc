#include "free_masses.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace birdstrike;
using birdstrike::test::FreeMasses;

// Points on targets of any mass: contact stays stable at the points' own step, its spring is a potential, and what its
// dampers take, by their own account, is what is missing of the energy.
namespace
{
  constexpr double spacing = 2e-3, density = 1000., sound_speed = 1000.;

  /// A layer of points, a spacing apart, that flies at a free plate of the given areal mass (kg/m^2).
  FreeMasses layer_on_plate(const double areal_mass, const double speed, const double cell)
  {
    FreeMasses   scene;
    const auto   n     = static_cast<unsigned int>(std::lround(20e-3 / cell));
    const double width = n * cell;
    scene.add_plate(n, n, cell, 0.);
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        scene.node[j * (n + 1) + i].inverse_mass =
          1. / (areal_mass * cell * cell * (i % n == 0 ? 0.5 : 1.) * (j % n == 0 ? 0.5 : 1.));
    scene.spacing        = spacing;
    scene.hugoniot_slope = 2.;
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    for (double y = 0.5 * spacing; y < width; y += spacing)
      for (double x = 0.5 * spacing; x < width; x += spacing)
        {
          FreeMasses::Point point;
          point.position    = Point3(x + jitter(random) * spacing, y + jitter(random) * spacing, 0.51 * spacing);
          point.velocity    = Point3(0., 0., -speed);
          point.mass        = density * spacing * spacing * spacing;
          point.density     = density;
          point.sound_speed = sound_speed;
          scene.add_point(point);
        }
    return scene;
  }

  /// Of the product of the velocities at the half steps before and behind: with a linear spring's energy leapfrog keeps
  /// their sum, while that with the velocities between them swings by (omega dt)^2/4.
  double kinetic_energy(const FreeMasses &scene, const double step)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < scene.id.size(); ++i)
      sum += 0.5 * scene.mass[i] *
             (scene.velocity(i).squaredNorm() - (0.5 * step / scene.mass[i] * scene.force_on_point(i)).squaredNorm());
    for (std::size_t n = 0; n < scene.node.size(); ++n)
      if (const auto &node = scene.node[n]; node.inverse_mass > 0.)
        sum += 0.5 / node.inverse_mass *
               (node.velocity.squaredNorm() - (0.5 * step * node.inverse_mass * scene.force_on_node(n)).squaredNorm());
    return sum;
  }
} // namespace

TEST(LightTarget, ContactMakesNoEnergyOnAnyMassAtAnySpeed)
{
  // 1 um of aluminium to a hundred times the layer's own mass, 1 to 1500 m/s, facets finer and coarser than points, at
  // the step of liquid under a Courant number of 0.45. Works are trapezoidal: the sum falls by up to
  // (omega dt)^2/8 in the step in which a touch begins, and rises again in the next; what is allowed above is for
  // springs that harden.
  ThreadPool pool;
  for (const double areal_mass : {2.7e-3, 0.1, 0.8, 20., 200.})
    for (const double speed : {1., 100., 1500.})
      for (const double cell : {1e-3, 5e-3})
        for (const double damping : {0., 1.})
          {
            if (cell < spacing && areal_mass < (damping > 0. ? 20. : 200.))
              continue; // nodes between the points, without a membrane, stay behind and fold the facets
            SCOPED_TRACE(testing::Message() << areal_mass << " kg/m^2, " << speed << " m/s, cells of " << cell
                                            << " m, damping " << damping);
            FreeMasses        scene = layer_on_plate(areal_mass, speed, cell);
            ContactParameters parameters;
            parameters.damping_scale = damping;
            Contact      contact(parameters);
            const double step = 0.45 * spacing / (sound_speed + 2. * 2. * speed);
            scene.compute_contact(contact, step, pool);
            const double before = kinetic_energy(scene, 0.);
            for (unsigned int n = 0; n < 300; ++n)
              {
                scene.advance(contact, step, pool);
                ASSERT_LE(kinetic_energy(scene, step) + contact.report().stored_energy, 1.02 * before) << n;
                ASSERT_LE(contact.report().dissipation_fall, 1e-3 * before) << n;
              }
            EXPECT_LE(kinetic_energy(scene, step) + contact.report().stored_energy, 1.01 * before);
            const double dissipated = contact.report().dissipated_energy;
            if (areal_mass >= 20.) // a bare light plate bounces at every second step
              {
                EXPECT_NEAR(scene.contact_work + contact.report().stored_energy + dissipated, 0., 0.05 * before);
              }
            EXPECT_EQ(dissipated > contact.report().released_energy, damping > 0.); // facets fold below some points
            // half a spacing, where a step alone may go a tenth
            EXPECT_LT(contact.report().max_penetration_over_spacing, 0.5 + speed * step / spacing);
          }
}

TEST(LightTarget, TheVoteOnTheStepCoversNodesThatAreLighterThanTheirFacets)
{
  // a node of a millionth of its neighbours' mass, and a modulus chosen for the facet: the vote must see it
  FreeMasses scene = layer_on_plate(20., 100., 5e-3);
  scene.node[2 * 5 + 2].inverse_mass *= 1e6;
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  double     step = 5e-7;
  scene.compute_contact(contact, step, pool);
  const double before = kinetic_energy(scene, 0.);
  for (unsigned int n = 0; n < 400; ++n)
    {
      step = std::min(1.02 * step, contact.step_limit().value);
      scene.advance(contact, step, pool);
      ASSERT_LE(kinetic_energy(scene, step) + contact.report().stored_energy, 1.03 * before) << n;
    }
  EXPECT_GT(contact.report().dissipated_energy, 0.);
}

TEST(LightTarget, LargestFrequencyBoundsTheSpringsOwn)
{
  // one point at rest in a facet of four free nodes: omega^2 = k (1/m + sum w^2/m_k), exact
  FreeMasses scene;
  scene.add_plate(1, 1, 0.01, 0.);
  for (auto &node : scene.node)
    node.inverse_mass = 1. / 1e-6;
  FreeMasses::Point point;
  point.position = Point3(0.003, 0.006, 0.49e-3);
  scene.add_point(point);
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  scene.compute_contact(contact, 1e-9, pool);
  scene.place(0, Point3(0.003, 0.006, 0.51e-3));
  scene.compute_contact(contact, 1e-9, pool);
  scene.place(0, Point3(0.003, 0.006, 0.49e-3));
  scene.compute_contact(contact, 1e-9, pool);
  const double stiffness = contact.report().peak_force / contact.report().max_penetration;
  double       weights   = 0.; // sum of squares
  for (std::size_t n = 0; n < 4; ++n)
    weights += std::pow(scene.force_on_node(n)[2] / scene.force_on_point(0)[2], 2);
  const double exact = stiffness * (1. / 1e-6 + weights / 1e-6);
  EXPECT_GE(std::pow(contact.report().largest_frequency, 2), exact * (1. - 1e-9));
  EXPECT_LE(std::pow(contact.report().largest_frequency, 2), 1.5 * exact); // Jensen's inequality gives that much away
}

// Points that four contacts share out among them take the same forces as if all were one contact's: the dampers of each
// own the part of a node's mass that their weight is of the weights of all.
TEST(LightTarget, SeveralContactsShareTheMassesOfTheNodesThatTheyTouch)
{
  ThreadPool pool;
  for (const double areal_mass : {0.1, 2., 200.})
    {
      FreeMasses                whole = layer_on_plate(areal_mass, 100., 5e-3);
      std::array<FreeMasses, 4> part;
      std::array<Contact, 4>    contacts{Contact(ContactParameters()), Contact(ContactParameters()),
                                      Contact(ContactParameters()), Contact(ContactParameters())};
      for (std::size_t k = 0; k < part.size(); ++k)
        {
          part[k].spacing        = spacing;
          part[k].hugoniot_slope = whole.hugoniot_slope;
          for (std::size_t i = k; i < whole.id.size(); i += part.size())
            part[k].add_point({whole.position(i), whole.velocity(i), whole.mass[i], density, sound_speed});
        }
      const double        step   = 5e-7;
      const FacetsView    facets = whole.facets();
      Contact             all{ContactParameters()};
      std::vector<double> weights, expected;
      double              largest = 0.;
      for (const double depth : {0., 0.02 * spacing}) // one call before they touch, to know the side
        {
          const auto lower = [&](FreeMasses &scene) {
            for (std::size_t i = 0; i < scene.id.size(); ++i)
              scene.place(i, scene.position(i) - Point3(0., 0., depth));
          };
          lower(whole);
          whole.compute_contact(all, step, pool);
          expected = whole.node_force;
          whole.node_force.assign(expected.size(), 0.);
          weights.assign(facets.n_nodes, 0.);
          for (std::size_t k = 0; k < part.size(); ++k)
            {
              lower(part[k]);
              for (auto &component : part[k].point_force)
                std::fill(component.begin(), component.end(), 0.);
              contacts[k].find(part[k].points(), facets, step, pool);
              contacts[k].add_weights(weights);
            }
          for (std::size_t k = 0; k < part.size(); ++k)
            {
              auto &force = part[k].point_force;
              contacts[k].act(part[k].points(), facets, step,
                              {{{force[0].data(), force[1].data(), force[2].data()}}, {whole.node_force.data(), 6}},
                              pool, &weights);
            }
        }
      EXPECT_GT(all.report().n_touching, whole.id.size() / 2);
      for (std::size_t i = 0; i < whole.id.size(); ++i)
        largest = std::max(largest, whole.force_on_point(i).norm());
      for (std::size_t i = 0; i < whole.id.size(); ++i)
        EXPECT_NEAR((part[i % 4].force_on_point(i / 4) - whole.force_on_point(i)).norm(), 0., 1e-12 * largest);
      for (std::size_t j = 0; j < expected.size(); ++j)
        EXPECT_NEAR(whole.node_force[j], expected[j], 1e-11 * largest);
    }
}

// Facets smaller than the points, so light that the springs are made softer: at a plane of symmetry, where nodes have
// half of their mass, as in the whole.
TEST(LightTarget, AHalfIsAsStiffAsTheWholeAtThePlaneOfSymmetry)
{
  constexpr double cell = 0.5 * spacing, areal_mass = 0.2;
  const auto       strike = [](const bool is_half) {
    FreeMasses     scene;
    constexpr auto n = 4U;
    scene.add_plate(n, is_half ? n : 2 * n, cell, 0., {0., is_half ? 0. : -cell * n, 0.});
    for (FreeMasses::Node &node : scene.node)
      node.inverse_mass = (is_half && node.position[1] == 0. ? 2. : 1.) / (areal_mass * cell * cell);
    if (is_half)
      for (unsigned int i = 0; i < n; ++i)
        scene.neighbor[i][0] = FacetsView::symmetry_edge;
    scene.plane   = SymmetryPlane(is_half);
    scene.spacing = spacing;
    for (const double side : {1., -1.})
      if (side > 0. || !is_half)
        scene.add_point({Point3(2.2 * cell, 0.4 * cell * side, 0.51 * spacing), Point3(0., 0., -10.),
                         density * spacing * spacing * spacing, density, sound_speed});
    ContactParameters parameters;
    parameters.damping_scale = 0.;
    Contact    contact(parameters);
    ThreadPool pool;
    scene.compute_contact(contact, 5e-7, pool);
    for (std::size_t i = 0; i < scene.id.size(); ++i)
      scene.fly_to(i, scene.position(i) - Point3(0., 0., 0.03 * spacing), 5e-7);
    scene.compute_contact(contact, 5e-7, pool);
    return scene.force_on_point(0);
  };
  const Point3 whole = strike(false), half = strike(true);
  EXPECT_GT(whole[2], 0.);
  EXPECT_LT((whole - half).norm(), 1e-10 * whole.norm());
}
