#include "crossings.h"
#include "strike_harness.h"

#include "simulation/stepper.h"
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/structure/blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

// A sheet folded to a U: two legs of 100 mm, 20 mm apart, joined and held at the riser x = 0. The bird throws the upper
// leg onto the lower one. Without self-contact the two pass through each other, in silence.
namespace
{
  constexpr int    n_leg = 14, n_riser = 3, n_chord = 6;
  constexpr double length = 0.1, height = 0.02, width = 0.06, thickness = 0.003;

  /// Middle line from the end of the lower leg to that of the upper, x and z.
  std::vector<std::array<double, 2>> path()
  {
    std::vector<std::array<double, 2>> points;
    for (int k = n_leg; k > 0; --k)
      points.push_back({length * k / n_leg, 0.});
    for (int k = 0; k < n_riser; ++k)
      points.push_back({0., height * k / n_riser});
    for (int k = 0; k <= n_leg; ++k)
      points.push_back({length * k / n_leg, height});
    return points;
  }

  /// Gmsh 2.2 text: quadrilaterals, or bricks in one layer with mitred corners. Ends have the ids 10 and 11.
  std::string folded_mesh(const bool is_solid)
  {
    const auto         line = path();
    const int          n = static_cast<int>(line.size()), n_layers = is_solid ? 2 : 1, row = n_chord + 1;
    std::ostringstream nodes, cells;
    int                n_elements = 0;
    for (int layer = 0; layer < n_layers; ++layer)
      for (int i = 0; i < n; ++i)
        {
          const auto direction = [&](const int a, const int b) {
            return std::array<double, 2>{(line[b][0] - line[a][0]), (line[b][1] - line[a][1])};
          };
          const auto before = direction(std::max(i - 1, 0), std::max(i, 1)),
                     after  = direction(std::min(i, n - 2), std::min(i + 1, n - 1));
          const double lb = std::hypot(before[0], before[1]), la = std::hypot(after[0], after[1]);
          const double nx = -before[1] / lb - after[1] / la, nz = before[0] / lb + after[0] / la;
          const double offset = is_solid ? (layer - 0.5) * thickness * 2. / (nx * nx + nz * nz) : 0.;
          const double chord  = width * (line[i][1] > 0.5 * height ? 0.85 : 1.); // rims do not meet edge on
          for (int j = 0; j <= n_chord; ++j)
            nodes << 1 + (layer * n + i) * row + j << ' ' << line[i][0] + offset * nx << ' '
                  << chord * (static_cast<double>(j) / n_chord - 0.5) << ' ' << line[i][1] + offset * nz << '\n';
        }
    const auto node    = [&](const int layer, const int i, const int j) { return 1 + (layer * n + i) * row + j; };
    const auto element = [&](const int type, const int id, const std::vector<int> &list) {
      cells << ++n_elements << ' ' << type << " 2 " << id << ' ' << id;
      for (const int k : list)
        cells << ' ' << k;
      cells << '\n';
    };
    for (int j = 0; j < n_chord; ++j)
      for (const int end : {0, n - 1})
        if (is_solid)
          element(3, end == 0 ? 10 : 11, {node(0, end, j), node(0, end, j + 1), node(1, end, j + 1), node(1, end, j)});
        else
          element(1, end == 0 ? 10 : 11, {node(0, end, j), node(0, end, j + 1)});
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j < n_chord; ++j)
        if (is_solid)
          element(5, 1,
                  {node(0, i, j), node(0, i + 1, j), node(0, i + 1, j + 1), node(0, i, j + 1), node(1, i, j),
                   node(1, i + 1, j), node(1, i + 1, j + 1), node(1, i, j + 1)});
        else
          element(3, 1, {node(0, i, j), node(0, i + 1, j), node(0, i + 1, j + 1), node(0, i, j + 1)});
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(n_layers * n * row) + "\n" + nodes.str() +
           "$EndNodes\n$Elements\n" + std::to_string(n_elements) + "\n" + cells.str() + "$EndElements\n";
  }

  struct Outcome
  {
    std::size_t           crossings = 0, touches = 0; ///< worst, sum
    double                deepest      = 0.;          ///< m, largest depth of a touch
    double                energy_error = 0., momentum_error = 0., dissipated = 0., fall = 0.;
    std::array<double, 3> momentum{};
    std::uint64_t         n_tested = 0;
  };

  /// A brick has no thickness beyond its skin: nodes are within it by 2.2 steps' flight of the legs, which approach at
  /// 60 m/s. A tenth of a millimetre on either side is a fifteenth of the thickness.
  constexpr double depth_of_bricks = 0.1e-3;

  /// Runs the strike and looks every ten steps whether anything goes through anything.
  Outcome run(const bool is_solid, const std::vector<std::string> &overrides = {})
  {
    std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-fold-XXXXXX").string();
    const std::filesystem::path folder  = mkdtemp(pattern.data());
    std::ofstream(folder / "folded.msh") << folded_mesh(is_solid);
    std::ofstream(folder / "case.prm")
      << "subsection Blade\n set Kind = " << (is_solid ? "solid" : "shell")
      << "\n subsection Mesh\n set Generator = file\n set File = " << (folder / "folded.msh").string() << "\n end\n"
      << " subsection Thickness\n set Value = " << thickness << "\n end\n"
      << " subsection Material\n set Name = Al 6061-T6\n end\n"
      << " subsection Supports\n set Clamped =\n set Hub = 10\n set Tip = 11\n set Free =\n"
      << (is_solid ? " set Held boxes = -0.01 -1 -1 0.0016 1 1: ux uy uz\n end\nend\n"
                   : " set Held boxes = -0.0001 -1 -1 0.0001 1 1: ux uy uz rx ry rz\n end\nend\n")
      << "subsection Bird\n set Mass = 0.03\n set Particle spacing = 0.005\n set Velocity = 0, 0, -150\n"
      << " set Aim point = 0.08, 0, 0.02\nend\nsubsection Time\n set End time = 0.5e-3\n set Threads = 1\nend\n";
    CaseParameters parameters;
    parameters.read((folder / "case.prm").string(), overrides);
    std::filesystem::remove_all(folder / "case.prm");

    const double depth = is_solid ? depth_of_bricks : 0.;

    Scene    scene(parameters);
    Timings  timings;
    Stepper  stepper(scene, timings);
    Balance  balance(10.);
    Outcome  result;
    Schedule schedule = scene.plan(parameters.time.end_time);
    stepper.compute_initial_forces(schedule.blade_step());
    balance.update(scene.state(), 0., 0);
    double        now = 0., dissipated = 0.;
    unsigned long k = 0;
    while (now < parameters.time.end_time * (1. - 1e-12))
      {
        schedule = scene.plan(parameters.time.end_time - now);
        stepper.advance(schedule);
        now += schedule.step;
        balance.update(scene.state(), now, ++k);
        result.fall = std::max(result.fall, dissipated - balance.state().self_contact.dissipated);
        dissipated  = balance.state().self_contact.dissipated;
        if (k % 10 == 0)
          result.crossings = std::max(result.crossings, count_crossings(scene.blade->facets(), depth));
      }
    std::filesystem::remove_all(folder);
    result.energy_error   = balance.energy_error().largest;
    result.momentum_error = balance.momentum_error().largest;
    result.dissipated     = dissipated;
    result.momentum       = balance.state().blade_momentum.momentum;
    if (scene.self_contact)
      {
        result.deepest  = scene.self_contact->report().max_penetration;
        result.touches  = scene.self_contact->report().touches;
        result.n_tested = scene.self_contact->report().pairs_tested;
      }
    return result;
  }

  class FoldedBlade : public ::testing::TestWithParam<bool>
  {
  };
} // namespace

TEST_P(FoldedBlade, LegsPassThroughOneAnotherOnlyWithoutSelfContact)
{
  EXPECT_GT(run(GetParam(), {"Contact/Self-contact=false"}).crossings, 10U);
  const Outcome folded = run(GetParam());
  EXPECT_EQ(folded.crossings, 0U);
  EXPECT_GT(folded.touches, 100U);
  EXPECT_LT(folded.deepest, 0.1 * thickness); // as the law promises for 150 m/s: 2.2 steps' flight, 0.2 mm
  EXPECT_GT(folded.dissipated, 0.);
  EXPECT_EQ(folded.fall, 0.);
  EXPECT_LT(folded.energy_error, 1e-2);    // found 0.06 % for shells, 0.6 % for bricks
  EXPECT_LT(folded.momentum_error, 1e-12); // forces between its own nodes are equal and opposite, held ones are booked
}

INSTANTIATE_TEST_SUITE_P(Kinds, FoldedBlade, ::testing::Bool(),
                         [](const auto &info) { return info.param ? "Solid" : "Shell"; });

TEST(SelfContactInAStrike, IsTheSameForAnyNumberOfThreads)
{
  const Outcome one   = run(false, {"Time/End time=0.3e-3"}),
                three = run(false, {"Time/End time=0.3e-3", "Time/Threads=3"});
  EXPECT_GT(one.touches, 0U);
  EXPECT_EQ(one.momentum, three.momentum);
  EXPECT_EQ(one.dissipated, three.dissipated);
}

TEST(SelfContactInAStrike, ComputesNothingWhereNothingFolds)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", {"Time/End time=0.2e-3"});
  Scene      scene(parameters);
  BirdStrike strike(parameters, scene);
  strike.run();
  ASSERT_TRUE(scene.self_contact);
  const SelfContactReport &report = scene.self_contact->report();
  EXPECT_GT(report.calls, 100U);
  EXPECT_LT(report.looks, report.calls / 4);
  EXPECT_EQ(report.pairs_tested, 0U);
}
