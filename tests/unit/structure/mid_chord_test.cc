#include <birdstrike/structure/probes/mid_chord.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace mid_chord_test
{
  using namespace birdstrike;

  namespace
  {
    constexpr double span = 0.3, chord = 0.09, thickness = 0.004; // m

    /// A plate in the plane z = const of n x m facets, y from y_begin to y_end; `side` -1 turns the facets over.
    struct Plate
    {
      std::vector<double>                       reference, position;
      std::vector<std::array<std::uint32_t, 4>> facets;

      void add(const unsigned int n, const unsigned int m, const double y_begin, const double y_end, const double z,
               const int side)
      {
        const auto first = static_cast<std::uint32_t>(reference.size() / 3);
        for (unsigned int i = 0; i <= n; ++i)
          for (unsigned int j = 0; j <= m; ++j)
            reference.insert(reference.end(), {span * i / n, y_begin + (y_end - y_begin) * j / m, z});
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < m; ++j)
            {
              const std::uint32_t a = first + i * (m + 1) + j, b = a + m + 1;
              if (side > 0)
                facets.push_back({a, b, b + 1, a + 1});
              else
                facets.push_back({a, a + 1, b + 1, b});
            }
        position = reference;
      }

      FacetsView view(const bool two_sided) const
      {
        FacetsView view;
        view.n_nodes   = reference.size() / 3;
        view.position  = position.data();
        view.n_facets  = facets.size();
        view.nodes     = facets.data();
        view.two_sided = two_sided;
        return view;
      }

      void move(const std::function<std::array<double, 3>(double, double, double)> &to)
      {
        for (std::size_t n = 0; n < reference.size(); n += 3)
          {
            const auto x = to(reference[n], reference[n + 1], reference[n + 2]);
            std::copy(x.begin(), x.end(), position.begin() + static_cast<std::ptrdiff_t>(n));
          }
      }
    };

    const SpanLine line{{{0., 0., 0.}}, {{span, 0., 0.}}, {{0., 0., 1.}}};

    /// A deflection that an interpolation along the chord must get right: linear in y.
    std::array<double, 3> bend(const double x, const double y, const double z)
    {
      return {{x, y, z + x * x + 3. * y * x}};
    }

    void expect_parabola(const Plate &plate, const MidChord &mid_chord, const std::size_t n_stations)
    {
      std::vector<double> deflection;
      mid_chord.compute_deflection(deflection);
      ASSERT_EQ(mid_chord.span_position().size(), n_stations);
      ASSERT_EQ(deflection.size(), n_stations);
      for (std::size_t k = 0; k < n_stations; ++k)
        {
          const double x = mid_chord.span_position()[k];
          EXPECT_NEAR(x, span * k / (n_stations - 1), 1e-15);
          EXPECT_NEAR(deflection[k], x * x, 1e-15) << "the chordwise part vanishes at mid-chord";
        }
      EXPECT_FALSE(plate.facets.empty());
    }
  } // namespace

  TEST(MidChord, FindsItBetweenNodesAndOnThem)
  {
    for (const unsigned int n_chord : {5u, 6u}) // mid-chord through facets, and along their edges
      {
        Plate plate;
        plate.add(7, n_chord, -0.5 * chord, 0.5 * chord, 0., 1);
        const MidChord mid_chord(plate.view(true), line);
        plate.move(bend);
        expect_parabola(plate, mid_chord, 8);
      }
  }

  TEST(MidChord, HalfABladeEndsAtThePlane)
  {
    for (const double sign : {-1., 1.})
      {
        Plate plate;
        plate.add(7, 3, sign > 0. ? 0. : -0.5 * chord, sign > 0. ? 0.5 * chord : 0., 0., 1);
        const MidChord mid_chord(plate.view(true), line);
        plate.move(bend);
        expect_parabola(plate, mid_chord, 8);
      }
  }

  TEST(MidChord, OfAClosedSkinItIsTheMeanOfBothFaces)
  {
    // faces with meshes of their own; the solid turns about the root, so that its faces shift along the span
    Plate solid;
    solid.add(7, 4, -0.5 * chord, 0.5 * chord, 0.5 * thickness, 1);
    solid.add(9, 5, -0.5 * chord, 0.5 * chord, -0.5 * thickness, -1);
    const MidChord mid_chord(solid.view(false), line);
    const double   angle = std::numbers::pi / 3.;
    solid.move([&](const double x, const double y, const double z) {
      return std::array<double, 3>{
        {x * std::cos(angle) - z * std::sin(angle), y, x * std::sin(angle) + z * std::cos(angle)}};
    });
    std::vector<double> deflection;
    mid_chord.compute_deflection(deflection);
    ASSERT_EQ(deflection.size(), 8u);
    // one face alone would be t/2 (1 - cos 60) = 1 mm off
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_NEAR(deflection[k], mid_chord.span_position()[k] * std::sin(angle), 1e-15);
  }

  TEST(MidChord, APlaneThatMissesTheSurfaceHasNoStations)
  {
    Plate plate;
    plate.add(7, 3, 0.01, 0.05, 0., 1);
    const MidChord      mid_chord(plate.view(true), line);
    std::vector<double> deflection{1.};
    mid_chord.compute_deflection(deflection);
    EXPECT_TRUE(mid_chord.span_position().empty());
    EXPECT_TRUE(deflection.empty());
  }
} // namespace mid_chord_test
