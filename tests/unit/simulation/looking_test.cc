#include "simulation/explain.h"
#include "simulation/scene.h"
#include "simulation/stepper.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

#include <gtest/gtest.h>

#include <cstring>

using namespace birdstrike;

/// Looking changes nothing: every const member of scene, bird and blade called in every step, or none at all, the same
/// positions and velocities to the last bit. Not a tolerance: what only reads cannot change a digit.
namespace
{
  void look(const CaseParameters &parameters, const Scene &scene)
  {
    EXPECT_FALSE(explain(parameters, scene).whole.empty());
    scene.state();
    scene.last_plan();
    scene.n_list_changes();
    if (scene.has_bird())
      {
        const Bird &bird = *scene.birds.front().bird;
        bird.step_limit();
        bird.points();
        bird.energies();
        bird.momenta();
        bird.snapshot();
        bird.summary();
      }
    if (scene.blade)
      {
        const Blade &blade = *scene.blade;
        blade.step_limit();
        blade.largest_stable_step();
        blade.facets();
        blade.contact_force();
        blade.energies();
        blade.momenta();
        blade.census();
        blade.snapshot();
        blade.probes();
        blade.root_section();
        blade.tip_deflection();
        blade.peak_plastic_strains();
        blade.failure();
        blade.span_line();
      }
  }

  void append(std::vector<double> &values, const double *begin, const std::size_t n)
  {
    values.insert(values.end(), begin, begin + n);
  }

  /// Positions and velocities after some steps.
  std::vector<double> run(const std::string &file, const std::vector<std::string> &overrides, const bool is_looked_at)
  {
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/" + file, overrides);
    Scene      scene(parameters);
    Timings    timings;
    Stepper    stepper(scene, timings);
    const auto look_if_asked = [&] {
      if (is_looked_at)
        look(parameters, scene);
    };
    look_if_asked();
    stepper.compute_initial_forces(scene.plan(1.).bird_step());
    for (unsigned int step = 0; step < 60; ++step)
      {
        look_if_asked();
        stepper.advance(scene.plan(1.));
      }
    std::vector<double> values;
    if (scene.has_bird())
      for (unsigned int d = 0; d < 3; ++d)
        {
          append(values, scene.birds.front().bird->points().position[d], scene.birds.front().bird->points().n);
          append(values, scene.birds.front().bird->points().velocity[d], scene.birds.front().bird->points().n);
        }
    if (scene.blade)
      {
        const FacetsView facets = scene.blade->facets();
        append(values, facets.position, 3 * facets.n_nodes);
        append(values, facets.velocity, facets.velocity_stride * facets.n_nodes);
      }
    return values;
  }

  void expect_same(const std::string &file, const std::vector<std::string> &overrides)
  {
    const auto unseen = run(file, overrides, false), seen = run(file, overrides, true);
    ASSERT_EQ(unseen.size(), seen.size());
    EXPECT_EQ(std::memcmp(unseen.data(), seen.data(), unseen.size() * sizeof(double)), 0);
  }

  const std::string coarse_particles = "Bird/Particle spacing=0.006";
} // namespace

TEST(Looking, LeavesAStrikeOnShellsAsItIs)
{
  expect_same("quickstart.prm", {coarse_particles});
}

TEST(Looking, LeavesAStrikeOnScaledBricksAsItIs)
{
  expect_same("quickstart.prm",
              {coarse_particles, "Blade/Kind=solid", "Blade/Mesh/Elements along span=14",
               "Blade/Mesh/Elements along chord=4", "Blade/Mesh/Layers=2", "Blade/Mass scaling/Method=selective"});
}

TEST(Looking, LeavesAFreeBirdAsItIs)
{
  expect_same("bird-free.prm", {coarse_particles});
}

TEST(Looking, LeavesAStrikeOnARigidPlateAsItIs)
{
  expect_same("rigid-plate.prm", {coarse_particles});
}
