#include "split_case.h"
#include "structure/nodes/loads.h"
#include "structure/nodes/supports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

// A mesh cut in two, each half with its own nodes, ghosts and the cells that touch its own nodes: what a process of a
// run on several would have. Everything on owned nodes is that of the whole, to the last bit: sums go in the same
// order.
namespace birdstrike::split_test
{
  namespace
  {
    /// Elements on a mesh, or on a part of one, and the motion of their nodes.
    template <int dim>
    struct Moving
    {
      static constexpr unsigned int n = BladeMesh<dim>::n_unknowns;

      const BladeMesh<dim>                                           &mesh;
      decltype(make_elements(mesh, "", std::declval<ThreadPool &>())) elements;
      std::vector<double>                                             position, increment, force;

      Moving(const BladeMesh<dim> &mesh, const std::string &formulation, ThreadPool &pool)
        : mesh(mesh)
        , elements(make_elements(mesh, formulation, pool))
        , increment(n * mesh.nodes.size() + 24, 0.)
        , force(increment)
      {
        for (const auto &x : mesh.nodes)
          position.insert(position.end(), x.begin(), x.end());
        position.resize(position.size() + 24);
      }

      /// Bends, twists and stretches, to some per cent: titanium yields.
      void step(const unsigned int k)
      {
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
          {
            const Point3 x = mesh.node(node);
            for (unsigned int c = 0; c < n; ++c)
              increment[n * node + c] =
                (c < 3 ? 4e-4 : 4e-3) * std::sin(20. * x[0] + 31. * x[1] + 57. * x[2] + c + 0.3 * k);
            for (unsigned int d = 0; d < 3; ++d)
              position[3 * node + d] += increment[n * node + d];
          }
        elements.compute_internal_forces(position.data(), increment.data(), 1e-6, force.data());
      }
    };

    /// Entries of an owned node are those of the whole's.
    void expect_equal(const NodeSpace &space, const unsigned int n, const std::vector<double> &whole,
                      const std::vector<double> &part, const std::string &what)
    {
      for (std::uint32_t node = 0; node < space.n_owned(); ++node)
        ASSERT_EQ(
          std::memcmp(&whole[std::size_t(n) * space.global(node)], &part[std::size_t(n) * node], n * sizeof(double)), 0)
          << what << " at node " << space.global(node);
    }

    template <int dim>
    void expect_same_forces(const std::string &formulation)
    {
      const Halves<dim> blade;
      ThreadPool        pool(2);
      Moving<dim>       whole(blade.whole, formulation, pool);
      for (unsigned int k = 0; k < 12; ++k)
        whole.step(k);
      ASSERT_GT(whole.elements.plastic_work(), 0.);
      for (const auto &mesh : blade.parts)
        {
          Moving<dim> part(mesh, formulation, pool);
          for (unsigned int k = 0; k < 12; ++k)
            part.step(k);
          expect_equal(mesh.space, Moving<dim>::n, whole.force, part.force, formulation);
        }
    }

    template <int dim>
    void expect_same_nodes()
    {
      const Halves<dim> blade;
      const auto        p    = twisted_blade();
      const auto        mass = mass_of(blade.whole);
      const Supports    supports(p.supports, blade.whole);
      const Loads       loads(p.loads, blade.whole, blade.whole.surface().cells);
      const auto        force_of = [&](const BladeMesh<dim> &mesh, const Loads &of) {
        std::vector<double> position, force(mesh.n_unknowns * mesh.nodes.size(), 0.);
        for (const auto &x : mesh.nodes)
          position.insert(position.end(), x.begin(), x.end());
        of.add_forces(1e-3, position.data(), force.data());
        return force;
      };
      double                     total   = 0.;
      std::size_t                n_cells = 0, n_points = 0;
      std::vector<std::uint32_t> held, tip;
      for (const auto &mesh : blade.parts)
        {
          EXPECT_GT(mesh.space.size(), mesh.space.n_owned()) << "ghosts";
          EXPECT_LT(mesh.space.size(), blade.whole.space.size());
          const auto here = mass_of(mesh);
          expect_equal(mesh.space, 1, mass.node, here.node, "mass");
          if (dim == 2)
            expect_equal(mesh.space, 1, mass.rotary, here.rotary, "rotary inertia");
          total += here.total;
          for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
            n_cells += mesh.is_owned(cell);
          for (const std::uint32_t dof : Supports(p.supports, mesh).held_dofs)
            held.push_back(mesh.n_unknowns * mesh.space.global(dof / mesh.n_unknowns) + dof % mesh.n_unknowns);
          for (const std::uint32_t node : mesh.nodes_on({1}))
            tip.push_back(mesh.space.global(node));
          expect_equal(mesh.space, mesh.n_unknowns, force_of(blade.whole, loads),
                       force_of(mesh, Loads(p.loads, mesh, mesh.surface().cells)), "loads");
          n_points += mesh.nearest_node(Point3(0.15, 0.01, 0.01)).has_value();
        }
      EXPECT_NEAR(total / mass.total, 1., 1e-14) << "round-off of a sum of a hundred";
      EXPECT_EQ(n_cells, blade.whole.cells.size()) << "each is owned once";
      std::sort(held.begin(), held.end());
      EXPECT_EQ(held, supports.held_dofs);
      std::sort(tip.begin(), tip.end());
      EXPECT_EQ(tip, blade.whole.nodes_on({1}));
      EXPECT_EQ(n_points, 1u);
    }

    TEST(Split, ShellForcesAreThoseOfTheWhole)
    {
      for (const char *formulation : {"physical", "Belytschko-Tsay", "fully integrated"})
        expect_same_forces<2>(formulation);
    }

    TEST(Split, SolidForcesAreThoseOfTheWhole)
    {
      for (const char *formulation : {"one point", "B-bar", "solid-shell"})
        expect_same_forces<3>(formulation);
    }

    TEST(Split, NodesOfAShellAreThoseOfTheWhole)
    {
      expect_same_nodes<2>();
    }

    TEST(Split, NodesOfASolidAreThoseOfTheWhole)
    {
      expect_same_nodes<3>();
    }
  } // namespace
} // namespace birdstrike::split_test
