#include "simulation/guards.h"
#include "strike_harness.h"

#include "structure/deformable_blade.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  // 10 times 177.4 m/s and twice the shock in the bird, or the sound speed of titanium, 5069 m/s: limits of 4.6 and
  // 11.9 km/s
  constexpr double slow = 4e3, fast = 13e3;

  struct FrontalCase
  {
    CaseParameters         parameters;
    std::unique_ptr<Scene> scene;

    explicit FrontalCase(std::vector<std::string> overrides = {})
    {
      overrides.insert(overrides.end(), {"Bird/Particle spacing=8 mm", "Blade/Mesh/Elements along span=12",
                                         "Blade/Mesh/Elements along chord=4"});
      parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm", overrides);
      scene = std::make_unique<Scene>(parameters);
    }
    void set_node(const std::size_t node, const double speed) const
    {
      dynamic_cast<ShellBlade &>(*scene->blade).nodes().velocity[6 * node + 2] = speed;
    }
    void set_particle(const std::uint32_t id, const double speed) const
    {
      std::uint32_t k = 0; // in the order of memory
      scene->birds.front().bird->set_state([&](Point3 &, Point3 &v, double &) {
        if (scene->birds.front().bird->state().id[k++] == id)
          v[0] = speed;
      });
    }
  };

  FailureFacts failure_of(const std::function<void()> &run)
  {
    try
      {
        run();
      }
    catch (const NumericalFailure &failure)
      {
        return failure.facts();
      }
    return {};
  }
} // namespace

TEST(Guards, StopARunawayNode)
{
  const FrontalCase frontal;
  const Guards      guards(frontal.parameters, *frontal.scene);
  EXPECT_NO_THROW(guards.check_motion(*frontal.scene, 0.));
  frontal.set_node(40, slow);
  EXPECT_NO_THROW(guards.check_motion(*frontal.scene, 0.)) << "slower than waves in titanium";
  frontal.set_node(40, fast);
  const FailureFacts facts = failure_of([&] { guards.check_motion(*frontal.scene, 0.); });
  EXPECT_EQ(facts.what, "A node has run away");
  EXPECT_STREQ(facts.where.kind, "node");
  EXPECT_EQ(facts.where.id, 40u);
  EXPECT_DOUBLE_EQ(facts.value, fast);
  EXPECT_LT(facts.limit, fast);
  EXPECT_EQ(find_fastest(*frontal.scene).where.id, 40u);
}

TEST(Guards, StopANodeWhoseMotionIsNoNumber)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    {
      const FrontalCase frontal;
      const Guards      guards(frontal.parameters, *frontal.scene);
      frontal.set_node(40, bad);
      const FailureFacts facts = failure_of([&] { guards.check_motion(*frontal.scene, 0.); });
      EXPECT_EQ(facts.what, "The motion of a node is no number") << bad;
      EXPECT_EQ(facts.where.id, 40u);
      EXPECT_EQ(find_fastest(*frontal.scene).where.id, 40u);
    }
}

TEST(Guards, StopARunawayParticle)
{
  const FrontalCase frontal;
  const Guards      guards(frontal.parameters, *frontal.scene);
  frontal.set_particle(17, slow);
  EXPECT_NO_THROW(guards.check_motion(*frontal.scene, 0.));
  frontal.set_particle(17, fast);
  const FailureFacts facts = failure_of([&] { guards.check_motion(*frontal.scene, 0.); });
  EXPECT_EQ(facts.what, "A particle has run away");
  EXPECT_STREQ(facts.where.kind, "particle");
  EXPECT_EQ(facts.where.id, 17u);
  EXPECT_LT(facts.limit, 6e3);
}

// Loads may bring a blade from rest to any speed: its own energy says so.
TEST(Guards, FollowABladeThatLoadsMakeFast)
{
  const FrontalCase frontal;
  const Guards      guards(frontal.parameters, *frontal.scene);
  frontal.set_node(40, fast);
  const double mean = 0.5 * fast;
  EXPECT_NO_THROW(guards.check_motion(*frontal.scene, 0.5 * frontal.scene->blade->mass() * mean * mean));
}

// Springs of a millionth of the liquid's stiffness and no damper hold nothing back.
TEST(Guards, StopAParticleThatComesThroughTheBlade)
{
  FrontalCase frontal({"Contact/Stiffness scale=1e-6", "Contact/Damping scale=0"});
  BirdStrike  strike(frontal.parameters, *frontal.scene);
  const auto  facts = failure_of([&] { strike.run(); });
  EXPECT_EQ(facts.what, "A particle is stuck in the blade, or has come through it");
  EXPECT_STREQ(facts.where.kind, "particle");
  EXPECT_GT(facts.value, facts.limit);
  EXPECT_NEAR(facts.where.position[0], 0.15, 0.15) << "on the blade";
  ASSERT_TRUE(facts.time && facts.step);
  EXPECT_GT(*facts.time, 0.);
  EXPECT_NE(facts.details.find("element"), std::string::npos) << facts.details;
}

TEST(Guards, RefuseACheckpointOfALostState)
{
  const FrontalCase frontal;
  BirdStrike        strike(frontal.parameters, *frontal.scene);
  strike.start();
  EXPECT_NO_THROW(strike.require_sound_state());
  frontal.set_node(40, fast);
  EXPECT_THROW(strike.require_sound_state(), NumericalFailure);
}

// The balance knows no entity: what moves fastest is named.
TEST(Guards, NameTheFastestWhereTheEnergyIsLost)
{
  FrontalCase frontal({"Time/Energy error limit=1e-9"});
  BirdStrike  strike(frontal.parameters, *frontal.scene);
  const auto  facts = failure_of([&] { strike.run(); });
  EXPECT_EQ(facts.quantity, "energy error");
  EXPECT_NE(facts.role.find("the fastest"), std::string::npos);
  EXPECT_NE(facts.where.kind, nullptr);
  EXPECT_TRUE(facts.time && facts.step);
}
