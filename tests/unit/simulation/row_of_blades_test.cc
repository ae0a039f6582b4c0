#include "../record.h"
#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/number.h>

#include <gtest/gtest.h>

#include <numbers>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  const std::string fan   = BIRDSTRIKE_SOURCE_DIR "/prm/fan-row.prm";
  const double      pitch = 2. * std::numbers::pi / 22.;

  /// About the axis of the engine, y.
  Point3 turn(const double angle, const Point3 &x)
  {
    return Eigen::AngleAxisd(angle, Point3::UnitY()) * x;
  }

  const Field &field(const FieldSnapshot &snapshot, const std::string &name)
  {
    return *std::ranges::find(snapshot.fields, name, &Field::name);
  }
} // namespace

// Twist, camber and thickness by formulas in x, y, z belong to the blade that is described; the others are its images,
// in mass, in static equilibrium under spin, and in the place that fields tell.
TEST(RowOfBlades, EachBladeIsTheDescribedOneTurned)
{
  for (const std::string kind : {"shell", "solid"})
    {
      const Overrides of{"Bird/Enabled=false",
                         "Blade/Kind=" + kind,
                         "Blade/Mesh/Elements along span=8",
                         "Blade/Mesh/Elements along chord=4",
                         "Blade/Mesh/Profile/Stagger=30+20*s",
                         "Blade/Mesh/Profile/Camber=0.05",
                         "Blade/Thickness/Value=0.006-0.004*(x-0.15)+0.01*y"};
      CaseParameters  row, one;
      row.read(fan, of);
      Overrides alone = of;
      alone.push_back("Blade/Mesh/Row/Blades=1");
      alone.push_back("Blade/Mesh/Row/Place=1");
      one.read(fan, alone);
      Scene of_row(row), of_one(one);
      EXPECT_NEAR(of_row.blade->mass(), 3. * of_one.blade->mass(), 1e-12 * of_row.blade->mass());
      const FieldSnapshot all = of_row.blade->snapshot(), first = of_one.blade->snapshot();
      const auto         &u = field(all, "displacement").values, &u_first = field(first, "displacement").values;
      const std::size_t   n = first.points.size() / 3;
      ASSERT_EQ(all.points.size(), 9 * n);
      EXPECT_EQ(field(all, "blade").values.front(), 2.);
      double largest = 0.;
      for (const double each : u_first)
        largest = std::max(largest, std::abs(each));
      EXPECT_GT(largest, 1e-4);
      // a node of the row is the image of one of the single blade, found by its place
      std::size_t n_found = 0;
      for (std::size_t k = 0; k < 3 * n; ++k)
        {
          const Point3 x(all.points.data() + 3 * k), moved(u.data() + 3 * k);
          for (const double angle : {0., pitch, -pitch})
            {
              const Point3 back = turn(-angle, x);
              for (std::size_t j = 0; j < n; ++j)
                if ((Point3(first.points.data() + 3 * j) - back).norm() < 1e-9)
                  {
                    ++n_found;
                    EXPECT_NEAR((turn(-angle, moved) - Point3(u_first.data() + 3 * j)).norm(), 0., 1e-6 * largest);
                  }
            }
        }
      EXPECT_EQ(n_found, 3 * n);
      const TipDeflection tip = of_row.blade->tip_deflection(), alone_tip = of_one.blade->tip_deflection();
      EXPECT_NEAR(tip.mid_chord, alone_tip.mid_chord, 1e-6 * largest) << "of the described blade alone";
      const double force = of_one.blade->root_section().normal_force;
      EXPECT_NEAR(of_row.blade->root_section().normal_force, force, 1e-6 * force);
    }
}

// Each blade cuts off what flies by while the fan turns by a pitch: m = rho pi D^2/4 v 2 pi/(n w), counted at the plane
// before the leading edges by the planes of the turning blades (the bird's particles are 4 mm apart there, and a slice
// is 48 mm long). And each blade of the two that take whole slices gets the same impulse within what slices differ by
// behind.
TEST(RowOfBlades, SlicesAreWhatTheGeometryGives)
{
  CaseParameters parameters;
  parameters.read(fan, {"Bird/Particle spacing=0.003", "Blade/Mesh/Elements along span=12",
                        "Blade/Mesh/Elements along chord=6", "Time/End time=1.3e-3", "Output/Console interval=1e9"});
  Scene            scene(parameters);
  BirdStrike       strike(parameters, scene);
  const double     entry = -0.05, stagger = std::numbers::pi / 6., speed = 600.; // m, rad, rad/s
  std::vector<int> blades_passed(scene.birds.front().n_at_start, -1);            // when it comes to the entry
  const double     mass = scene.birds.front().at_start.mass / static_cast<double>(blades_passed.size());
  strike.run([&](bool) {
    if (!scene.birds.front().bird)
      return;
    const PointsView points = scene.birds.front().bird->points();
    for (std::size_t p = 0; p < points.n; ++p)
      {
        int &passed = blades_passed[points.id[p]];
        if (passed >= 0 || points.position[1][p] < entry)
          continue;
        passed              = 0;
        const double when   = strike.time() - (points.position[1][p] - entry) / 100.; // also before the clock started
        const Point3 on_hub = turn(-speed * when, {points.position[0][p], entry, points.position[2][p]});
        for (const int place : {-1, 0, 1})
          {
            const Point3 x = turn(-pitch * place, on_hub);
            passed += -std::sin(stagger) * x[1] + std::cos(stagger) * x[2] > 0.;
          }
      }
  });
  const double radius = 0.02; // of 143.3 g, three times as long as thick
  const double slice  = 950. * std::numbers::pi * radius * radius * 100. * 2. * std::numbers::pi / (22. * speed);
  for (const int between : {1, 2})
    {
      const double cut = mass * static_cast<double>(std::ranges::count(blades_passed, between));
      record("slice " + std::to_string(between), cut / slice);
      EXPECT_NEAR(cut, slice, 0.02 * slice) << between;
    }
  std::vector<double> row(scene.histories.tables.back()->columns.size());
  scene.histories.tables.back()->fill(row);
  const auto impulse = [&](const std::string &blade) {
    const auto &columns = scene.histories.tables.back()->columns;
    const auto  x       = std::ranges::find(columns, blade + ".impulse_x", &Column::name) - columns.begin();
    return Point3(row.data() + x).norm();
  };
  EXPECT_GT(impulse("blade_2"), 6.);
  EXPECT_NEAR(impulse("blade_1"), impulse("blade_2"), 0.35 * impulse("blade_2"));
  EXPECT_LT(impulse("blade_3"), 0.2 * impulse("blade_2"));
  const SystemState state = scene.state();
  double            whole = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    {
      double sum = 0.;
      for (const char *blade : {"blade_1", "blade_2", "blade_3"})
        {
          const auto &columns = scene.histories.tables.back()->columns;
          sum += row[static_cast<std::size_t>(
                       std::ranges::find(columns, std::string(blade) + ".impulse_x", &Column::name) - columns.begin()) +
                     d];
        }
      whole = std::max(whole, std::abs(sum - state.blade_momentum.contact_impulse[d]));
    }
  record("impulse of the blades less that of all", whole);
  EXPECT_LT(whole, 1e-9) << "of all blades together";
}

// What is in the way is so for the blades that are struck, however many stand all around.
TEST(RowOfBlades, TheShareInTheWayDoesNotHangOnBladesOnTheOtherSide)
{
  const Overrides coarse{"Blade/Mesh/Elements along span=6", "Blade/Mesh/Elements along chord=3",
                         "Bird/Particle spacing=0.006", "Blade/Spin/Prestress=false"};
  const auto      share = [&](const std::string &blades, const std::string &place) {
    Overrides all = coarse;
    all.push_back("Blade/Mesh/Row/Blades=" + blades);
    all.push_back("Blade/Mesh/Row/Place=" + place);
    CaseParameters parameters;
    parameters.read(fan, all);
    return Scene(parameters).birds.front().first_touch.share_in_the_way;
  };
  EXPECT_NEAR(share("22", "11"), share("8", "4"), 1e-3);
}

// Two plates 10 mm apart, the first of which is struck: the second takes it up (self-contact is that of blades too).
TEST(RowOfBlades, BladesThatMeetDoNotGoThroughOneAnother)
{
  const Strike strike = run_shipped("quickstart.prm", {"Blade/Mesh/Row/Blades=2", "Blade/Mesh/Row/Pitch=0.573",
                                                       "Blade/Spin/Axis=1, 0, 0", "Blade/Spin/Centre=0, -1, 0",
                                                       "Blade/Probes=struck: 0.3112 0 0; behind: 0.3112 0 0.01",
                                                       "Time/End time=1e-3", "Output/History interval=1e-5"});
  const auto  &struck = strike.curves.at("probe_struck_uz"), &behind = strike.curves.at("probe_behind_uz");
  double       nearest = 1.;
  for (std::size_t k = 0; k < struck.size(); ++k)
    nearest = std::min(nearest, 0.01 + behind[k] - struck[k]);
  EXPECT_GT(nearest, 0.8 * 4.27e-3) << "a thickness between the middles of both";
  EXPECT_LT(nearest, 1.3 * 4.27e-3) << "they have met";
  EXPECT_GT(behind.back(), 0.01);
  EXPECT_LT(strike.summary.number("energy/max_relative_error"), 2e-3);
}

// Three blades of which the outer ones are rigid: these are neither computed nor bent, take part in contact, and follow
// the hub. They are the limit of blades that are stiff, here by thirty times the modulus of titanium.
TEST(RowOfBlades, RigidOnesFollowTheHub)
{
  const Overrides coarse{"Blade/Mesh/Elements along span=10", "Blade/Mesh/Elements along chord=5",
                         "Bird/Particle spacing=0.005",       "Time/End time=0.8e-3",
                         "Output/Console interval=1e9",       "Blade/Material/Young's modulus=3.4e12",
                         "Blade/Material/Hardening=elastic"};
  const auto      strike = [&](const std::string &kind, const std::string &rigid) {
    Overrides all = coarse;
    all.push_back("Blade/Kind=" + kind);
    all.push_back("Blade/Mesh/Row/Rigid=" + rigid);
    auto parameters = std::make_unique<CaseParameters>();
    parameters->read(fan, all);
    auto       scene = std::make_unique<Scene>(*parameters);
    BirdStrike run(*parameters, *scene);
    run.run([](bool) {});
    return std::tuple(std::move(parameters), std::move(scene), run.time());
  };
  for (const std::string kind : {"shell", "solid"})
    {
      const auto [of_rigid, rigid, time]    = strike(kind, "1 3");
      const auto [of_elastic, elastic, end] = strike(kind, "");
      const auto balance = rigid->blade->balance_of_row(), before = elastic->blade->balance_of_row();
      ASSERT_EQ(balance.size(), 3u);
      const FieldSnapshot snapshot = rigid->blade->snapshot();
      const auto         &u        = field(snapshot, "displacement").values;
      const double        turned   = 600. * time;
      std::size_t         n_rigid  = 0;
      for (std::size_t cell = 0; cell < field(snapshot, "blade").values.size(); ++cell)
        if (field(snapshot, "blade").values[cell] != 2.)
          for (std::size_t k = 0; k < (kind == "shell" ? 4u : 8u); ++k, ++n_rigid)
            {
              const std::uint32_t n = snapshot.cells[(kind == "shell" ? 4 : 8) * cell + k];
              const Point3        x(snapshot.points.data() + 3 * n), moved(u.data() + 3 * n);
              EXPECT_NEAR((x + moved - turn(turned, x)).norm(), 0., 1e-12);
            }
      EXPECT_GT(n_rigid, 100u);
      for (const std::size_t k : {0u, 2u})
        {
          EXPECT_TRUE(balance[k].is_rigid);
          EXPECT_EQ(balance[k].energies.elastic, 0.);
          EXPECT_EQ(balance[k].energies.plastic, 0.);
          EXPECT_NEAR(balance[k].energies.kinetic, before[k].energies.kinetic, 0.02 * before[k].energies.kinetic);
        }
      for (const std::size_t k : {0u, 1u, 2u})
        EXPECT_NEAR((Point3(balance[k].impulse.data()) - Point3(before[k].impulse.data())).norm(), 0.,
                    0.03 * Point3(before[1].impulse.data()).norm())
          << kind << k;
      const ElementPrices price = rigid->blade->prices(), all = elastic->blade->prices();
      EXPECT_EQ(3 * price.n_elements, all.n_elements);
      // sums over the blades are the whole
      EnergyReport sum;
      for (const BladeBalance &of : before)
        {
          sum.elastic += of.energies.elastic;
          sum.plastic += of.energies.plastic;
          sum.kinetic += of.energies.kinetic;
        }
      const EnergyReport whole = elastic->blade->energies();
      EXPECT_NEAR(sum.elastic, whole.elastic, 1e-12 * whole.elastic);
      EXPECT_NEAR(sum.plastic, whole.plastic, 1e-12 * whole.plastic + 1e-12);
      EXPECT_NEAR(sum.kinetic, whole.kinetic, 1e-12 * whole.kinetic);
      // and the described blade is among them
      const auto   loads = elastic->blade->loads_of_row();
      const double tip   = elastic->blade->tip_deflection().mid_chord;
      EXPECT_NEAR(loads[1].tip.mid_chord, tip, 1e-12);
      EXPECT_NEAR(loads[1].root.bending_moment, elastic->blade->root_section().bending_moment,
                  1e-9 * std::abs(loads[1].root.bending_moment));
    }
}

// Before anything is struck, copies carry and report what the described blade does.
TEST(RowOfBlades, CopiesReportInTheirOwnAxes)
{
  for (const std::string kind : {"shell", "solid"})
    {
      CaseParameters parameters;
      parameters.read(fan, {"Bird/Enabled=false", "Blade/Kind=" + kind, "Blade/Mesh/Elements along span=8",
                            "Blade/Mesh/Elements along chord=4", "Blade/Mesh/Row/Pitch=120",
                            "Blade/Mesh/Profile/Stagger=30+20*s", "Blade/Mesh/Profile/Camber=0.05"});
      const Scene scene(parameters);
      const auto  loads = scene.blade->loads_of_row();
      ASSERT_EQ(loads.size(), 3u);
      const BladeLoads &described = loads[1];
      EXPECT_GT(std::abs(described.tip.mid_chord), 1e-4);
      for (const BladeLoads &of : loads)
        {
          EXPECT_NEAR(of.tip.mid_chord / described.tip.mid_chord, 1., 1e-5) << kind << of.place;
          EXPECT_NEAR(of.tip.leading / described.tip.leading, 1., 1e-5) << kind << of.place;
          EXPECT_NEAR(of.root.normal_force / described.root.normal_force, 1., 1e-6) << kind << of.place;
          EXPECT_NEAR(of.root.bending_moment / described.root.bending_moment, 1., 1e-5) << kind << of.place;
          EXPECT_NEAR(of.tip.trailing / described.tip.trailing, 1., 1e-5) << kind << of.place;
          EXPECT_NEAR(of.root.transverse_force / described.root.transverse_force, 1., 1e-4) << kind << of.place;
          ASSERT_EQ(of.root.stress_rear.size(), described.root.stress_rear.size());
          for (std::size_t k = 0; k < of.root.stress_struck.size(); ++k)
            EXPECT_NEAR(of.root.stress_struck[k] / described.root.stress_struck[k], 1., 1e-4) << kind << of.place;
          for (std::size_t k = 0; k < of.root.stress_rear.size(); ++k)
            EXPECT_NEAR(of.root.stress_rear[k] / described.root.stress_rear[k], 1., 1e-4) << kind << of.place;
        }
    }
}

TEST(RowOfBlades, RefusesRigidPlacesThatAreNone)
{
  for (const char *rigid : {"4", "2", "0", "one"})
    {
      CaseParameters parameters;
      EXPECT_THROW(parameters.read(fan, {std::string("Blade/Mesh/Row/Rigid=") + rigid}), InputError) << rigid;
    }
}

// All around a hub the mean velocity of the blades is zero, and told nothing of which side of one is struck: the sign
// of deflections hung on how many stood on the other side.
TEST(RowOfBlades, TheStruckSideIsTheDescribedBlades)
{
  const auto tip = [&](const std::string &blades, const std::string &rigid) {
    CaseParameters parameters;
    parameters.read(fan, {"Blade/Mesh/Elements along span=6", "Blade/Mesh/Elements along chord=4",
                          "Blade/Mesh/Profile/Camber=0.05", "Blade/Mesh/Profile/Stagger=30+20*s",
                          "Bird/Particle spacing=0.008", "Blade/Mesh/Row/Blades=" + blades,
                          "Blade/Mesh/Row/Rigid=" + rigid});
    const Scene scene(parameters);
    return scene.blade->tip_deflection().mid_chord;
  };
  std::string  others = "1 3";
  const double few    = tip("3", others);
  for (int k = 4; k <= 22; ++k)
    others += " " + std::to_string(k);
  EXPECT_GT(std::abs(few), 1e-4);
  EXPECT_NEAR(tip("22", others) / few, 1., 1e-9);
}
