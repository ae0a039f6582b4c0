#include "split_case.h"
#include "structure/census.h"
#include "structure/nodes/nodal_mechanics.h"
#include <birdstrike/core/energy_report.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

// The motion of a mesh cut in two, each half stepped by itself and told nothing but the velocities of its ghosts: every
// owned node moves as in the whole, to the last bit, and what is summed over owned entities adds up to the whole's.
namespace birdstrike::split_motion_test
{
  namespace
  {
    BladeParameters struck_blade()
    {
      BladeParameters p        = twisted_blade();
      p.supports.driven        = "1: ux = 2e-4*sin(3e4*t)";
      p.loads.damping          = 300.;
      p.loads.initial_velocity = "120; 180*sin(40*x); 300*x/0.3";
      return p;
    }

    template <int dim>
    struct Process
    {
      static constexpr unsigned int n = BladeMesh<dim>::n_unknowns;

      const BladeMesh<dim>                                           &mesh;
      typename BladeMesh<dim>::Mass                                   mass;
      decltype(make_elements(mesh, "", std::declval<ThreadPool &>())) elements;
      NodalMechanics<n>                                               motion;

      static typename NodalMechanics<n>::Masses masses(const typename BladeMesh<dim>::Mass &mass)
      {
        return {mass.node, mass.rotary};
      }

      Process(const BladeMesh<dim> &mesh, const BladeParameters &p, const std::string &formulation, const double yield,
              ThreadPool &pool)
        : mesh(mesh)
        , mass(mass_of(mesh))
        , elements(make_elements(mesh, formulation, pool, yield))
        , motion(mesh, masses(mass), Supports(p.supports, mesh), Loads(p.loads, mesh, mesh.surface().cells), Rotor(),
                 pool)
      {
        elements.set_owned(mesh.space.n_owned(), mesh.owned_cells());
        elements.use_nodal_masses(mass.node);
        motion.initialize_velocity(p.loads);
      }

      void begin_step(const double dt)
      {
        motion.kick_internal(0.5 * dt, HalfKick::first);
        motion.kick_contact(0.5 * dt, HalfKick::first);
      }

      void end_step(const double dt, const unsigned int k)
      {
        motion.drift(dt);
        motion.compute_internal_forces(elements);
        const NodeForces sink = motion.clear_contact_forces();
        for (std::uint32_t node = 0; node < mesh.space.size(); ++node)
          for (unsigned int d = 0; d < 3; ++d)
            sink.of(node)[d] = 20. * std::sin(0.7 * mesh.space.global(node) + d + 0.1 * k);
        motion.kick_internal(0.5 * dt, HalfKick::second);
        motion.kick_contact(0.5 * dt, HalfKick::second);
      }

      /// Velocities of ghosts are those of their owner.
      void receive(Process &from)
      {
        for (std::uint32_t ghost = mesh.space.n_owned(); ghost < mesh.space.size(); ++ghost)
          std::memcpy(motion.arrays().velocity + std::size_t(n) * ghost,
                      from.motion.arrays().velocity + std::size_t(n) * from.mesh.space.local(mesh.space.global(ghost)),
                      n * sizeof(double));
      }

      EnergyReport energies() const
      {
        EnergyReport report = motion.energies();
        elements.add_energies(report);
        return report;
      }
    };

    /// Tolerance: round-off of sums of some hundred terms, of either sign.
    void expect_sum(const double whole, const double one, const double other, const double scale, const char *what)
    {
      EXPECT_NEAR(whole, one + other, 1e-12 * scale) << what;
    }

    constexpr double no_yield = 1e15; // Pa

    template <int dim>
    void expect_same_motion(const std::string &formulation, const double yield)
    {
      const Halves<dim>     blade;
      const BladeParameters p = struck_blade();
      ThreadPool            pool(2);
      Process<dim> whole(blade.whole, p, formulation, yield, pool), one(blade.parts[0], p, formulation, yield, pool),
        other(blade.parts[1], p, formulation, yield, pool);
      one.receive(other);
      other.receive(one);
      const double dt = 0.6 * whole.elements.largest_stable_step();
      for (unsigned int k = 0; k < 60; ++k)
        {
          for (auto *process : {&whole, &one, &other})
            process->begin_step(dt);
          one.receive(other);
          other.receive(one);
          for (auto *process : {&whole, &one, &other})
            process->end_step(dt, k);
          ASSERT_EQ(whole.elements.largest_stable_step(),
                    std::min(one.elements.largest_stable_step(), other.elements.largest_stable_step()))
            << formulation << ", yield stress " << yield;
          ASSERT_EQ(whole.elements.step_limit().value,
                    std::min(one.elements.step_limit().value, other.elements.step_limit().value));
        }

      for (auto *part : {&one, &other})
        for (std::uint32_t node = 0; node < part->mesh.space.n_owned(); ++node)
          ASSERT_EQ(std::memcmp(part->motion.arrays().velocity + std::size_t(part->n) * node,
                                whole.motion.arrays().velocity + std::size_t(part->n) * part->mesh.space.global(node),
                                part->n * sizeof(double)),
                    0)
            << formulation << ", velocity of node " << part->mesh.space.global(node);

      const EnergyReport e = whole.energies(), a = one.energies(), b = other.energies();
      EXPECT_EQ(e.plastic > 0., yield < no_yield);
      EXPECT_NE(e.damped * e.external_work * e.contact_work, 0.);
      for (const EnergyKind &kind : energy_kinds)
        expect_sum(e.*kind.value, a.*kind.value, b.*kind.value, e.kinetic, kind.name);
      const MomentumReport m = whole.motion.momenta(), m_a = one.motion.momenta(), m_b = other.motion.momenta();
      for (const auto scale : momentum_scales)
        expect_sum(m.*scale, m_a.*scale, m_b.*scale, m.*scale, "scale");
      for (const MomentumKind &kind : momentum_kinds)
        for (unsigned int d = 0; d < 3; ++d)
          expect_sum((m.*kind.value)[d], (m_a.*kind.value)[d], (m_b.*kind.value)[d],
                     kind.is_axial ? m.moment_scale : m.impulse_scale, kind.name);
      for (unsigned int d = 0; d < 3; ++d)
        expect_sum(whole.motion.contact_force()[d], one.motion.contact_force()[d], other.motion.contact_force()[d], 1e3,
                   "contact force");
      EXPECT_EQ(
        whole.elements.max_plastic_strains().front().value,
        std::max(one.elements.max_plastic_strains().front().value, other.elements.max_plastic_strains().front().value));
    }

    template <int dim>
    void expect_same_census()
    {
      const Halves<dim> blade;
      const BladeCensus whole = compute_census(blade.whole), one = compute_census(blade.parts[0]),
                        other = compute_census(blade.parts[1]);
      EXPECT_EQ(whole.n_elements, blade.whole.cells.size());
      EXPECT_EQ(whole.n_elements, one.n_elements + other.n_elements);
      EXPECT_EQ(whole.n_nodes, one.n_nodes + other.n_nodes);
      EXPECT_EQ(whole.smallest_edge, std::min(one.smallest_edge, other.smallest_edge));
      expect_sum(whole.area, one.area, other.area, whole.area, "area");
    }

    TEST(SplitMotion, ShellsMoveAsTheWhole)
    {
      for (const char *formulation : {"physical", "Belytschko-Tsay", "fully integrated"})
        expect_same_motion<2>(formulation, no_yield);
    }

    TEST(SplitMotion, BricksMoveAsTheWhole)
    {
      for (const char *formulation : {"one point", "B-bar", "solid-shell"})
        expect_same_motion<3>(formulation, no_yield);
    }

    // Not shells and one-point bricks: where they flow, all lanes of a batch iterate until the last has converged, so
    // that last bits depend on which elements share one.
    TEST(SplitMotion, BricksFlowAsTheWhole)
    {
      for (const char *formulation : {"B-bar", "solid-shell"})
        expect_same_motion<3>(formulation, 880e6);
    }

    TEST(SplitMotion, CensusesAddUp)
    {
      expect_same_census<2>();
      expect_same_census<3>();
    }
  } // namespace
} // namespace birdstrike::split_motion_test
