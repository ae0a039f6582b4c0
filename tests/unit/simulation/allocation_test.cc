#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/allocation_guard.h>
#include <birdstrike/simulation/stepper.h>

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
