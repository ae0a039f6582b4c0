#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

/// Birds whose place at time 0 is given.
namespace
{
  constexpr double speed = 150., half_thickness = 0.004, far = 0.5; // m/s, m, m

  /// A rigid plate at z = 0, and a cylinder of mass 0.1 kg that flies along its axis: its length is twice its diameter.
  const std::string plate = "subsection Blade\n set Kind = rigid\n subsection Rigid\n  set Length = 1\n"
                            "  set Width = 1\n  set Half thickness = 4 mm\n end\nend\n"
                            "subsection Bird\n set Mass = 0.1\n set Particle spacing = 5 mm\n"
                            "  set Velocity = 0, 0, 150\nend\nsubsection Time\n set End time = 4 ms\nend\n";

  /// m = rho pi/4 d^2 2 d
  double half_length()
  {
    return std::cbrt(2. * 0.1 / (950. * std::acos(-1.)));
  }

  struct Placed
  {
    CaseParameters         parameters;
    std::unique_ptr<Scene> scene;

    explicit Placed(const std::string &file, const Overrides &overrides)
    {
      parameters.read(file, overrides);
      scene = std::make_unique<Scene>(parameters);
    }
    const Projectile &bird(const std::size_t k = 0) const
    {
      return scene->birds[k];
    }
    /// Of the particles, m.
    Point3 centre(const std::size_t k = 0) const
    {
      const PointsView points = bird(k).bird->points();
      Point3           sum    = Point3::Zero();
      for (std::size_t p = 0; p < points.n; ++p)
        sum += Point3(points.position[0][p], points.position[1][p], points.position[2][p]);
      return sum / static_cast<double>(points.n);
    }
    /// From the centre to where contact begins along z, m: half a spacing before the foremost particles.
    double reach(const std::size_t k = 0) const
    {
      const PointsView points = bird(k).bird->points();
      const auto       z      = points.position[2];
      return *std::max_element(z, z + points.n) - centre(k)[2] + 0.5 * points.spacing;
    }
  };

  std::string plate_file()
  {
    static const std::string file = [] {
      const auto path = std::filesystem::temp_directory_path() / ("position-" + std::to_string(::getpid()) + ".prm");
      std::ofstream(path) << plate;
      return path.string();
    }();
    return file;
  }

  std::string refusal_of_position(const Overrides &overrides)
  {
    try
      {
        const Placed placed(plate_file(), overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "accepted";
  }
} // namespace

// The nose has to fly from its place to the face: far - reach - half of the thickness. Contact begins half a spacing
// (the cube root of a particle's volume) before the foremost layer's centres. Layers fill the length, and one is as
// thick as a spacing within 2 %: so the reach is half of the length within 1 % of a spacing. Arrivals are 1e-6 of a
// spacing early.
TEST(Position, ABirdOfKnownNoseTouchesWhenGeometrySays)
{
  for (const Overrides &aside : {Overrides{"Bird/Position=0.1, -0.2, -0.5"}, Overrides{"Bird/Position=0, 0, -500 mm"}})
    {
      const Placed placed(plate_file(), aside);
      EXPECT_NEAR(placed.reach(), half_length(), 0.01 * 0.005);
      EXPECT_NEAR(placed.bird().parameters.arrival, (far - placed.reach() - half_thickness) / speed, 1e-10);
      EXPECT_NEAR(placed.centre()[2], -far, 1e-12);
      EXPECT_NEAR(placed.bird().aim.point[0], placed.centre()[0], 1e-9) << "the path goes through the aim";
      EXPECT_NEAR(placed.bird().aim.point[2], 0., half_thickness + 1e-9);
      EXPECT_EQ(placed.scene->flight_time(), 0.) << "nothing is skipped: time 0 is the position's";
    }
  // obliquely: the lower rim of the front face comes first; along z the centre has (0, 50, 100) m/s
  const Placed oblique(plate_file(), {"Bird/Position=0, -0.2, -0.5", "Bird/Velocity=0, 50, 100", "Bird/Shape=sphere"});
  const double radius = std::cbrt(3. * 0.1 / (4. * std::acos(-1.) * 950.));
  EXPECT_NEAR(oblique.bird().parameters.arrival, (far - radius - half_thickness) / 100., 0.005 / 100.)
    << "to the lattice of a sphere: its first particle is within a spacing";
}

TEST(Position, IsTheStrikeOfItsAimPointAndArrivalTime)
{
  const double by_hand = (far - half_length() - half_thickness) / speed;
  const Placed placed(plate_file(), {"Bird/Position=0.1, 0, -0.5"});
  const Strike here = run_text(plate, {"Bird/Position=0.1, 0, -0.5"});
  const Strike there =
    run_text(plate, {"Bird/Aim point=0.1, 0, 0", "Bird/Arrival time=" + std::to_string(1e3 * by_hand) + " ms"});
  const double impulse = there.summary.number("contact/impulse/2");
  EXPECT_GT(impulse, 0.1 * speed);
  EXPECT_NEAR(here.summary.number("contact/impulse/2"), impulse, 2e-3 * impulse) << "steps end elsewhere";
  EXPECT_NEAR(here.summary.number("contact/peak_force_time"), there.summary.number("contact/peak_force_time"), 2e-6);
  EXPECT_NEAR(here.summary.number("aim/arrival_time"), (far - placed.reach() - half_thickness) / speed, 1e-10);
  EXPECT_EQ(here.summary.number("aim/position/2"), -far);
}

TEST(Position, AgreesWithWhatIsGivenBesideItOrIsRefused)
{
  const double      by_hand  = (far - half_length() - half_thickness) / speed;
  const std::string position = "Bird/Position=0.1, 0, -0.5";
  EXPECT_EQ(refusal_of_position({position, "Bird/Aim point=0.1, 0, 0"}), "accepted");
  EXPECT_EQ(refusal_of_position({position, "Bird/Aim point=0.1, 0, 0.3"}), "accepted") << "anywhere on its path";
  EXPECT_EQ(refusal_of_position({position, "Bird/Arrival time=" + std::to_string(1e3 * by_hand) + " ms"}), "accepted");
  const auto expect = [&](const Overrides &more, const char *text) {
    const std::string said = refusal_of_position(with({position}, more));
    EXPECT_NE(said.find(text), std::string::npos) << said;
  };
  expect({"Bird/Arrival time=2 ms"}, "Bird/Arrival time = 0.002 s contradicts Bird/Position");
  expect({"Bird/Aim point=0.11, 0, 0"}, "Bird/Aim point contradicts Bird/Position");
  expect({"Bird/Stand-off=0.2"}, "'Stand-off': it is given beside Position");
  expect({"Bird/Chordwise offset=0.01"}, "'Chordwise offset': it is given beside Position");
  expect({"Bird/Velocity=default", "Bird/Speed=100", "Bird/Angle to surface=90"}, "Angle to surface");
  expect({"Bird/Position=0.1, 0"}, "Give three numbers");
  expect({"Bird/Position=0.1, 0, 0"}, "starts inside the blade");
  expect({"Bird/Position=0.1, 0, 0.5"}, "misses the blade");
  expect({"Bird/Position=2, 0, -0.5"}, "Bird/Position");
}

// Each bird has its own; one that gives none lies where the first one is, which is refused.
TEST(Position, IsOfEachBird)
{
  const Placed two(plate_file(), {"Bird/Position=0.1, 0, -0.5", "Bird 2/Enabled=true", "Bird 2/Position=0.1, 0, -0.8"});
  EXPECT_NEAR(two.bird(1).parameters.arrival - two.bird(0).parameters.arrival, 0.3 / speed, 1e-10);
  EXPECT_NE(refusal_of_position({"Bird/Position=0.1, 0, -0.5", "Bird 2/Enabled=true"}).find("starts inside that of"),
            std::string::npos);
  const Placed aimed(plate_file(),
                     {"Bird/Position=0.1, 0, -0.5", "Bird 2/Enabled=true", "Bird 2/Aim point=-0.2, 0, 0"});
  EXPECT_NEAR(aimed.centre(1)[0], -0.2, 1e-9) << "an aim of its own replaces the first one's position";
}

// A slice's position is that of the whole bird: its planes at -10 and 20 mm along the axis cut the nose off.
TEST(Position, OfASliceIsThatOfTheWholeBird)
{
  const Placed placed(plate_file(), {"Bird/Position=0, 0, -0.5", "Bird/Slice/Between=-0.01, 0.02"});
  // its planes are half a layer before the centres; the whole bird's centre is at the position
  double           front  = -1.;
  const PointsView points = placed.bird().bird->points();
  for (std::size_t p = 0; p < points.n; ++p)
    front = std::max(front, points.position[2][p] + 0.5 * points.spacing);
  EXPECT_NEAR(front, -far + 0.02, 0.01 * 0.005);
  EXPECT_NEAR(placed.bird().parameters.arrival, (-half_thickness - front) / speed, 1e-10);
}

// The whole plate moves against the bird at 50 m/s: they close in at 200 m/s.
TEST(Position, OfABladeThatMovesIsMetInItsFrame)
{
  const Overrides moving{
    "Blade/Loads/Initial velocity=0; 0; -50", "Blade/Supports/Clamped=",    "Bird/Velocity=0, 0, 150",
    "Bird/Position=0.21784, 0, -0.5",         "Bird/Particle spacing=5 mm", "Bird/Mass=0.1"};
  const Placed placed(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm", moving);
  EXPECT_NEAR(placed.bird().parameters.arrival, (far - placed.reach() - 0.5 * 0.00427) / 200., 1e-10);
}

// fan-blade.prm turns: the strike of an aim point at a time of arrival, told by the place where that bird is at time 0.
TEST(Position, OfABladeThatTurnsIsWhereTheAimedBirdHasBeen)
{
  const std::string fan = BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade-spin.prm";
  const Overrides coarse{"Bird/Slice/Number of blades=0", "Bird/Aim chord fraction=0.3", "Bird/Particle spacing=0.008",
                         "Blade/Mesh/Elements along span=20", "Blade/Mesh/Elements along chord=8"};
  const Placed    aimed(fan, with(coarse, {"Bird/Arrival time=1 ms"}));
  const Point3    x = aimed.bird().bird->packing().centre;
  // the packing's centre before it was moved: the particles have gone with it
  const Placed       again(fan, with(coarse, {"Bird/Arrival time=1 ms"}));
  const Point3       centre = again.centre();
  Overrides          from   = with(coarse, {"Bird/Aim span fraction=default", "Bird/Aim chord fraction=default"});
  std::ostringstream place;
  place.precision(17);
  place << "Bird/Position=" << centre[0] << ", " << centre[1] << ", " << centre[2];
  from.push_back(place.str());
  const Placed placed(fan, from);
  const double spacing = 0.008;
  EXPECT_NEAR((placed.centre() - centre).norm(), 0., 1e-3 * spacing);
  EXPECT_NEAR(placed.bird().parameters.arrival, 1e-3, 0.5 * spacing / placed.bird().first_touch.closing_speed);
  EXPECT_NEAR((Point3(placed.bird().aim.point.data()) - Point3(aimed.bird().aim.point.data())).norm(), 0., spacing);
  EXPECT_EQ(x, again.bird().bird->packing().centre);
}
