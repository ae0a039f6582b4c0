#include "shell_harness.h"
#include "solid_harness.h"

#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cstring>

// Elements of several sections: groups of one class.
namespace birdstrike::element_groups_test
{
  namespace
  {
    constexpr std::size_t n_elements = 12 * 5;

    /// Every third element has the second section: batches of the groups hold other elements than those of one.
    std::vector<std::uint32_t> every_third()
    {
      std::vector<std::uint32_t> of_element(n_elements, 0);
      for (std::size_t e = 0; e < n_elements; e += 3)
        of_element[e] = 1;
      return of_element;
    }

    /// Forces after three elastic steps of a smooth motion with small rotations.
    template <class Elements>
    std::vector<double> deform(Elements &&elements, const std::vector<Point3> &nodes)
    {
      constexpr unsigned int n_unknowns = std::decay_t<Elements>::n_unknowns;
      std::vector<double>    position, increment(n_unknowns * nodes.size()), force(increment.size());
      for (const Point3 &x : nodes)
        position.insert(position.end(), {x[0], x[1], x[2]});
      for (int step = 0; step < 3; ++step)
        {
          for (std::size_t n = 0; n < nodes.size(); ++n)
            for (unsigned int c = 0; c < n_unknowns; ++c)
              {
                increment[n_unknowns * n + c] = 1e-6 * std::sin(1. + 3. * c + 5. * nodes[n][0] - 2. * nodes[n][1]);
                if (c < 3)
                  position[3 * n + c] += increment[n_unknowns * n + c];
              }
          elements.compute_internal_forces(position.data(), increment.data(), 1e-6, force.data());
        }
      return force;
    }

    template <class Elements, class Section, class Make>
    void expect_two_as_one(const Section &section, const std::vector<Point3> &nodes, const Make &make)
    {
      const auto one = deform(make(Sections<Section>(section)), nodes);
      const auto two = deform(make(Sections<Section>({section, section}, every_third())), nodes);
      EXPECT_GT(std::abs(one[0]), 0.);
      EXPECT_EQ(std::memcmp(one.data(), two.data(), one.size() * sizeof(double)), 0);
      Elements   elements = make(Sections<Section>({section, section}, every_third()));
      const auto of_one   = make(Sections<Section>(section));
      EXPECT_EQ(elements.largest_stable_step(), of_one.largest_stable_step());
      EXPECT_EQ(elements.step_limit().where.id, of_one.step_limit().where.id);
      EXPECT_EQ(elements.compute_nodal_masses(), of_one.compute_nodal_masses());
    }

    // While elastic, a lane does what it would in any batch, and forces add up in the order of the mesh: to the last
    // bit.
    TEST(ElementGroups, TwoSectionsOfOneMetalAreAsOne)
    {
      ThreadPool pool(2);
      const auto surface = shell_harness::warped_mesh(12, 5);
      for (const auto formulation : shell_harness::all_formulations)
        expect_two_as_one<ShellElements>(shell_harness::make_section(1e9, 0.3, formulation), surface.nodes,
                                         [&](const Sections<ShellSection> &sections) {
                                           return ShellElements(surface.nodes, surface.cells,
                                                                std::vector<double>(n_elements, 0.01), sections, pool);
                                         });
      const auto body = solid_harness::make_box({12, 5, 1}, Point3(1., 0.5, 0.1));
      for (const auto formulation :
           {SolidFormulation::one_point, SolidFormulation::b_bar, SolidFormulation::solid_shell})
        expect_two_as_one<SolidElements>(solid_harness::make_section(1e9, 0.3, formulation), body.nodes,
                                         [&](const Sections<SolidSection> &sections) {
                                           return SolidElements(body.nodes, body.cells, sections, pool);
                                         });
    }

    // A bar of two metals in a row, stretched by the ends' displacement: with nu = 0 both carry the force
    // F = A u/(L_1/E_1 + L_2/E_2), here of bricks with the interface at rest where equilibrium puts it. Plane sections
    // stay plane, so the elements are exact; increments of 1e-9 of the length leave 1e-8.
    TEST(ElementGroups, TwoMetalsInARowAreSpringsInSeries)
    {
      ThreadPool                 pool;
      const double               length = 0.6, area = 0.1 * 0.05, young[2] = {110e9, 70e9};
      const auto                 body = solid_harness::make_box({12, 5, 1}, Point3(length, 0.1, 0.05));
      std::vector<SolidSection>  sections{solid_harness::make_section(young[0], 0.),
                                         solid_harness::make_section(young[1], 0.)};
      std::vector<std::uint32_t> of_element;
      for (const auto &cell : body.cells)
        of_element.push_back(body.nodes[cell[0]][0] < 0.2 - 1e-9 ? 0 : 1); // a third of the length
      sections[1].material.density = 0.6;
      SolidElements       elements(body.nodes, body.cells, {sections, of_element}, pool);
      const double        u = 1e-9 * length, force = area * u / (0.2 / young[0] + 0.4 / young[1]);
      std::vector<double> position, increment(3 * body.nodes.size(), 0.), found(increment.size());
      for (std::size_t n = 0; n < body.nodes.size(); ++n)
        {
          const double x   = body.nodes[n][0];
          increment[3 * n] = force / area * (std::min(x, 0.2) / young[0] + std::max(x - 0.2, 0.) / young[1]);
          position.insert(position.end(), {x + increment[3 * n], body.nodes[n][1], body.nodes[n][2]});
        }
      elements.compute_internal_forces(position.data(), increment.data(), 1., found.data());
      double at_end = 0., inside = 0.;
      for (std::size_t n = 0; n < body.nodes.size(); ++n)
        {
          const double x = body.nodes[n][0];
          at_end += x > length - 1e-9 ? found[3 * n] : 0.;
          inside = std::max(inside, x > 1e-9 && x < length - 1e-9 ? std::abs(found[3 * n]) : 0.);
        }
      EXPECT_NEAR(at_end / force, -1., 1e-8);
      EXPECT_LT(inside, 1e-8 * force) << "in equilibrium at the interface too";
      EXPECT_NEAR(elements.section_sums(0).mass, area * 0.2 * 1., 1e-12);
      EXPECT_NEAR(elements.section_sums(1).mass, area * 0.4 * 0.6, 1e-12);
      EXPECT_EQ(elements.section(0).material.elasticity.young, young[0]);
    }

    TEST(ElementGroups, RefuseASectionWithoutElements)
    {
      ThreadPool pool;
      const auto body    = solid_harness::make_box({12, 5, 1}, Point3(1., 0.5, 0.1));
      const auto section = solid_harness::make_section(1e9, 0.3);
      EXPECT_THROW(
        SolidElements(body.nodes, body.cells, {{section, section}, std::vector<std::uint32_t>(n_elements, 0)}, pool),
        InputError);
    }
  } // namespace
} // namespace birdstrike::element_groups_test
