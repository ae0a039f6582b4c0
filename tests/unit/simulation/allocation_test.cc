#include "simulation/stepper.h"
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/allocation_guard.h>

#include "strike_harness.h"

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(AllocationGuard, CountsWhatIsAllocatedWhileItLives)
{
  ASSERT_TRUE(AllocationGuard::is_counting()) << "this test program is built to count";
  const AllocationGuard guard;
  EXPECT_EQ(guard.count(), 0u);
  const std::vector<double> plain(10);
  EXPECT_EQ(guard.count(), 1u);
  const std::vector<double, CacheLineAllocator<double>> aligned(10);
  EXPECT_EQ(guard.count(), 2u) << plain.size() + aligned.size();
}

TEST(AllocationGuard, StepsOfAWarmSceneAllocateNothing)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm",
                  {"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=20",
                   "Blade/Mesh/Elements along chord=6", "Time/Threads=1"});
  Timings    timings;
  Scene      scene(parameters);
  Stepper    stepper(scene, timings);
  double     now     = 0.;
  const auto advance = [&] {
    const Schedule schedule = scene.plan(1. - now);
    stepper.advance(schedule);
    now += schedule.step;
  };
  stepper.compute_initial_forces(scene.plan(1.).bird_step());
  while (now < 0.3e-3) // lists have been rebuilt, elements have yielded: every buffer has its size
    advance();
  unsigned int n_steps = 0, n_listing = 0;
  while (now < 0.35e-3)
    {
      const std::uint64_t   lists = scene.n_list_changes();
      const AllocationGuard guard;
      advance();
      const std::uint64_t count = guard.count();
      ++n_steps;
      if (scene.n_list_changes() != lists) // spray spreads: a list may outgrow all before
        ++n_listing;
      else
        ASSERT_EQ(count, 0u) << AllocationGuard::first_call_sites();
    }
  EXPECT_GT(n_steps, 2 * n_listing);
}
