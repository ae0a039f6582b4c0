#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/surface_map.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace birdstrike;

/// Where a bird is when the clock starts: touching, nowhere inside, having passed through nothing.
namespace
{
  const std::vector<std::string> square_plate{"Blade/Mesh/Length=0.3",
                                              "Blade/Mesh/Chord=0.3",
                                              "Blade/Mesh/Elements along span=10",
                                              "Blade/Mesh/Elements along chord=10",
                                              "Blade/Thickness/Value=0.01",
                                              "Blade/Supports/Clamped=0,1,2,3",
                                              "Bird/Particle spacing=0.008",
                                              "Bird/Aim point=0.15, 0, 0"};

  void expect_first_touch(std::vector<std::string> entries)
  {
    entries.insert(entries.begin(), square_plate.begin(), square_plate.end());
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", entries);
    Scene            scene(parameters);
    const PointsView points = scene.birds.front().bird->points();
    const FacetsView facets = scene.blade->facets();
    // placed a millionth of a spacing before it, to round-off of a flight of less than a metre
    const auto  &v      = parameters.bird.velocity;
    const double before = 1e-6 * parameters.bird.spacing / std::hypot(v[0], v[1], v[2]);
    EXPECT_EQ(initial_overlap(points, facets).depth, 0.) << entries.back();
    EXPECT_NEAR(time_to_first_touch(points, facets), before, 1e-12) << entries.back();
  }

  std::string refusal(std::vector<std::string> entries)
  {
    entries.insert(entries.begin(), square_plate.begin(), square_plate.end());
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", entries);
    try
      {
        Scene scene(parameters);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(Placement, ABirdOfAnyIncidenceStartsAtFirstTouch)
{
  for (const double degree : {0.5, 1., 5., 10., 30., 60., 90., 175., -5.})
    {
      const double a = degree * std::acos(-1.) / 180.;
      expect_first_touch(
        {"Bird/Velocity=0, " + std::to_string(200. * std::cos(a)) + ", " + std::to_string(200. * std::sin(a))});
      expect_first_touch(
        {"Bird/Velocity=" + std::to_string(200. * std::cos(a)) + ", 0, " + std::to_string(200. * std::sin(a))});
    }
}

TEST(Placement, ABirdWiderThanTheBladeOrAimedBesideItStartsAtFirstTouch)
{
  expect_first_touch({"Bird/Mass=20", "Bird/Particle spacing=0.03", "Bird/Velocity=0, 199, 17"});
  expect_first_touch({"Bird/Mass=20", "Bird/Particle spacing=0.03", "Bird/Velocity=199, 0, 0"});
  expect_first_touch({"Bird/Velocity=0, 199, 17", "Bird/Aim point=0.15, 0, 0.015"});
  expect_first_touch({"Bird/Velocity=0, 0, 177.4", "Bird/Aim point=0.15, 0, 0.5"}); // 0.5 m behind the blade
  expect_first_touch({"Bird/Yaw=80", "Bird/Velocity=0, 199, 17"});
}

namespace
{
  /// Gmsh 2.2 text of a plate along x, 0.3 m by 0.1 m, turned by R; ids 10 root, 11 tip, 12 and 13 the edges.
  std::string turned_plate(const Matrix3<double> &R)
  {
    constexpr int      n_span = 12, n_chord = 4, row = n_chord + 1;
    std::ostringstream text;
    text.precision(17);
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << (n_span + 1) * row << '\n';
    for (int i = 0; i <= n_span; ++i)
      for (int j = 0; j <= n_chord; ++j)
        {
          const Point3 x = R * Point3(0.3 * i / n_span, 0.1 * j / n_chord - 0.05, 0.);
          text << 1 + row * i + j << ' ' << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
        }
    text << "$EndNodes\n$Elements\n" << 2 * (n_span + n_chord) + n_span * n_chord << '\n';
    int        number = 0;
    const auto edge   = [&](const int id, const int a, const int b) {
      text << ++number << " 1 2 " << id << ' ' << id << ' ' << a << ' ' << b << '\n';
    };
    for (int j = 1; j <= n_chord; ++j)
      {
        edge(10, j, j + 1);
        edge(11, row * n_span + j, row * n_span + j + 1);
      }
    for (int i = 0; i < n_span; ++i)
      {
        edge(12, row * i + 1, row * (i + 1) + 1);
        edge(13, row * (i + 1), row * (i + 2));
      }
    for (int i = 0; i < n_span; ++i)
      for (int j = 1; j <= n_chord; ++j)
        text << ++number << " 3 2 1 1 " << row * i + j << ' ' << row * (i + 1) + j << ' ' << row * (i + 1) + j + 1
             << ' ' << row * i + j + 1 << '\n';
    text << "$EndElements\n";
    return text.str();
  }

  /// Particles at first touch of a bird that yaws and pitches against that plate, turned back.
  std::vector<Point3> places_at_turned_plate(const Matrix3<double> &R)
  {
    std::string pattern                = (std::filesystem::temp_directory_path() / "birdstrike-turned-XXXXXX").string();
    const std::filesystem::path folder = mkdtemp(pattern.data());
    std::ofstream(folder / "plate.msh") << turned_plate(R);
    const auto entry = [&](const std::string &name, const Point3 &x) {
      std::ostringstream text;
      text.precision(17);
      const Point3 there = R * x;
      text << name << '=' << there[0] << ", " << there[1] << ", " << there[2];
      return text.str();
    };
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm",
                    {"Blade/Mesh/Generator=file", "Blade/Mesh/File=" + (folder / "plate.msh").string(),
                     "Blade/Supports/Clamped=10", "Blade/Supports/Tip=11", "Blade/Supports/Free=12, 13",
                     "Bird/Particle spacing=0.006", "Bird/Yaw=40", "Bird/Pitch=15", "Bird/Stand-off=0.2",
                     entry("Bird/Velocity", Point3(20., 60., 140.)), entry("Bird/Aim point", Point3(0.2, 0., 0.))});
    const Scene      scene(parameters);
    const PointsView points = scene.birds.front().bird->points();
    std::filesystem::remove_all(folder);
    std::vector<Point3> places;
    for (std::size_t p = 0; p < points.n; ++p)
      places.push_back(R.transpose() * Point3(points.position[0][p], points.position[1][p], points.position[2][p]));
    return places;
  }
} // namespace

// The same strike in other axes: the bird lies as the span says, from root to tip, not as x does. Places are found by
// a flight of 0.2 m to within a millionth of a spacing, 6e-9 m; a yaw about x put them off by 30 mm.
TEST(Placement, ABirdLiesTheSameBesideABladeTurnedInSpace)
{
  const std::vector<Point3> there = places_at_turned_plate(Matrix3<double>::Identity());
  const Matrix3<double>     upright =
    Eigen::AngleAxisd(-0.5 * M_PI, Point3(Point3::UnitY())).toRotationMatrix(); // the span along z
  const Matrix3<double> tilted = Eigen::AngleAxisd(0.9, Point3(1., 2., 2.).normalized()).toRotationMatrix();
  for (const Matrix3<double> &R : {upright, tilted})
    {
      const std::vector<Point3> here = places_at_turned_plate(R);
      ASSERT_EQ(here.size(), there.size());
      double largest = 0.; // their order is that of cells along the axes
      for (const Point3 &x : here)
        {
          double nearest = INFINITY;
          for (const Point3 &y : there)
            nearest = std::min(nearest, (x - y).norm());
          largest = std::max(largest, nearest);
        }
      EXPECT_LT(largest, 1e-8);
    }
}

TEST(Placement, ABirdThatStandsStillIsRefusedAsSuch)
{
  for (const std::string entry : {"Bird/Stand-off=0", "Bird/Stand-off=0.5"})
    {
      const std::string still = refusal({"Bird/Velocity=0, 0, 0", entry});
      EXPECT_NE(still.find("does not close in"), std::string::npos) << still;
      EXPECT_EQ(still.find("inside"), std::string::npos) << still;
    }
}

TEST(Placement, AdviceIsNeverWhatIsSetAlready)
{
  const std::string near = refusal({"Bird/Velocity=0, 199, 17", "Bird/Stand-off=0.01"});
  EXPECT_NE(near.find("Enlarge Bird/Stand-off, or set it to 0"), std::string::npos) << near;
  const std::string slab = refusal({"Bird/Shape=slab", "Bird/Slab lengths=0.04,0.04,0.04", "Bird/Velocity=0, 0, 100"});
  EXPECT_NE(slab.find("inside"), std::string::npos) << slab;
  EXPECT_EQ(slab.find("Stand-off"), std::string::npos) << slab;
}

TEST(Placement, ATurningBladeIsMetAsFastAsItMovesWhereTheBirdAims)
{
  const Point3 omega(0., 300., 0.), centre(-0.25, 0., 0.), velocity(0., 110., 150.);
  for (const std::string kind : {"shell", "solid"})
    for (const std::string n : {"10", "14"})
      for (const double z : {-1e-6, 1e-6})
        {
          const Point3             aim(0.137, 0.011, z);
          std::vector<std::string> entries = square_plate;
          entries.insert(entries.end(),
                         {"Blade/Kind=" + kind, "Blade/Mesh/Elements along span=" + n, "Blade/Spin/Speed=300",
                          "Blade/Spin/Axis=0, 1, 0", "Blade/Spin/Centre=-0.25, 0, 0", "Blade/Spin/Prestress=false",
                          "Blade/Supports/Clamped=root", "Bird/Velocity=0, 110, 150",
                          "Bird/Aim point=0.137, 0.011, " + std::to_string(z)});
          CaseParameters parameters;
          parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", entries);
          const Scene  scene(parameters);
          const Point3 closing(scene.birds.front().first_touch.closing_velocity.data());
          EXPECT_LT((closing - (velocity - omega.cross(Point3(aim - centre)))).norm(), 1e-9) << kind << ", " << n;
        }
}

// Spin untwists the blade of fan-blade-spin.prm, by 11 mm across the planes of its slice at 70 % of the span: the near
// plane lies at the edge that the bird meets, not at that of the mesh.
TEST(Placement, ASliceBetweenBladesLiesAtTheEdgeAsSpinHasMovedIt)
{
  for (const char *kind : {"shell", "solid"})
    {
      SCOPED_TRACE(kind);
      CaseParameters parameters;
      parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade-spin.prm",
                      {"Blade/Kind=" + std::string(kind), "Blade/Mesh/Elements along span=22",
                       "Blade/Mesh/Elements along chord=9", "Bird/Particle spacing=0.008"});
      const Scene      scene(parameters);
      const PointsView points = scene.birds.front().bird->points();
      const Point3     normal(parameters.bird.slice_normal.data()), edge(parameters.bird.aimed_place->data());
      const Point3     moved  = scene.blade->motion_of(edge).displacement;
      double           middle = 0.;
      for (std::size_t p = 0; p < points.n; ++p)
        middle += normal.dot(Point3(points.position[0][p], points.position[1][p], points.position[2][p])) /
                  static_cast<double>(points.n);
      EXPECT_LT(normal.dot(moved), -0.008);
      // flown along the planes; 0.3 mm: they are those at the edge, the flight that at the aim point, 1 degree apart
      EXPECT_NEAR(middle - parameters.bird.slice_between[1], normal.dot(Point3(edge + moved)), 3e-4);
    }
}

namespace
{
  const std::vector<std::string> whole_bird_on_spinning_blade{
    "Blade/Mesh/Elements along span=22", "Blade/Mesh/Elements along chord=9", "Bird/Particle spacing=0.008",
    "Bird/Slice/Number of blades=0"};

  /// The scene of fan-blade-spin.prm, and where spin has moved places of its mid-surface.
  struct SpinningBlade
  {
    explicit SpinningBlade(std::vector<std::string> entries)
    {
      entries.insert(entries.begin(), whole_bird_on_spinning_blade.begin(), whole_bird_on_spinning_blade.end());
      parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/fan-blade-spin.prm", entries);
      scene.emplace(parameters);
      surface = make_surface_map(parameters.blade);
    }

    Point3 now(const double span, const double chord) const
    {
      const Point3 place = surface->position(span, chord);
      return place + scene->blade->motion_of(place).displacement;
    }
    /// Between the direction and the tangents of the surface by differences, degrees.
    double angle_to_surface(const Point3 &direction, const double span, const double chord) const
    {
      constexpr double d      = 0.05;
      const auto       inside = [](const double share) { return std::clamp(share, 0., 1.); };
      const Point3     along  = now(inside(span + d), chord) - now(inside(span - d), chord),
                   across     = now(span, inside(chord + d)) - now(span, inside(chord - d));
      return std::asin(std::abs(direction.normalized().dot(along.cross(across).normalized()))) * 180. / M_PI;
    }

    CaseParameters                    parameters;
    std::optional<Scene>              scene;
    std::unique_ptr<const SurfaceMap> surface;
  };
} // namespace

// An aim by shares of span and chord is a place of the blade, wherever spin has moved it: of fan-blade-spin.prm by 12
// mm at 40 % of the chord.
TEST(Placement, AnAimBySharesGoesWithTheBladeThatSpinHasMoved)
{
  for (const std::string kind : {"shell", "solid"})
    {
      SCOPED_TRACE(kind);
      const SpinningBlade of({"Blade/Kind=" + kind, "Bird/Aim chord fraction=0.4"});
      const Projectile   &bird = of.scene->birds.front();
      const Point3        aim  = of.now(0.7, 0.4);
      EXPECT_GT((aim - of.surface->position(0.7, 0.4)).norm(), 0.01);
      EXPECT_LT((aim - Point3(bird.aim.point.data())).norm(), 1e-9);

      const Point3 closing(bird.first_touch.closing_velocity.data());
      EXPECT_LT((closing - (Point3(0., 102.9, 0.) - 600. * Point3(0., 1., 0.).cross(aim))).norm(), 1e-9);
      const PointsView points = bird.bird->points(); // whose middle flies through the aim
      Point3           middle = Point3::Zero();
      for (std::size_t p = 0; p < points.n; ++p)
        middle += Point3(points.position[0][p], points.position[1][p], points.position[2][p]) / points.n;
      EXPECT_LT(closing.normalized().cross(middle - aim).norm(), 1e-6);
    }
}

// At the tip the nearest facet of a solid is one of its end, whose normal lies along the blade: it turns with the
// blade.
TEST(Placement, TheAngleIsThatToTheSurfaceAsSpinHasTurnedIt)
{
  for (const std::string kind : {"shell", "solid"})
    for (const auto &[span, chord] : {std::pair(0.7, 0.4), std::pair(1., 0.4), std::pair(0.7, 0.)})
      {
        SCOPED_TRACE(kind + " at " + std::to_string(span) + ", " + std::to_string(chord));
        const SpinningBlade of({"Blade/Kind=" + kind, "Bird/Aim span fraction=" + std::to_string(span),
                                "Bird/Aim chord fraction=" + std::to_string(chord)});
        const Projectile   &bird = of.scene->birds.front();
        const Point3        closing(bird.first_touch.closing_velocity.data()), rest = of.surface->normal(span, chord);
        const double        undeformed = std::asin(std::abs(closing.normalized().dot(rest))) * 180. / M_PI;
        EXPECT_NEAR(bird.aim.angle, of.angle_to_surface(closing, span, chord), 0.5);
        EXPECT_GT(std::abs(bird.aim.angle - undeformed), 1.5);
      }
}

// Half a chord of 185 mm from its middle lies as far from the leading edge as it did before spin turned the section.
TEST(Placement, AChordwiseOffsetGoesAlongTheChordAsSpinHasTurnedIt)
{
  for (const std::string kind : {"shell", "solid"})
    {
      SCOPED_TRACE(kind);
      const SpinningBlade of({"Blade/Kind=" + kind, "Bird/Aim chord fraction=0.5", "Bird/Chordwise offset=-0.0925"});
      const Projectile   &bird   = of.scene->birds.front();
      const Point3        before = Point3(of.parameters.bird.target().data()) - of.surface->position(0.7, 0.);
      const Point3        after  = Point3(bird.aim.point.data()) - of.now(0.7, 0.);
      EXPECT_NEAR(after.norm(), before.norm(), 5e-4);
    }
}
