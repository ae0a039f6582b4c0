#include "blade_case.h"
#include "laminate_case.h"
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

// Histories of layers of shells that bend, at rest.
namespace birdstrike::element_histories_test
{
  namespace
  {
    constexpr double chord = 0.0889, young = 113.8e9, poisson = 0.342;

    struct Seen
    {
      std::map<std::string, double>      value;
      std::map<std::string, std::string> meaning;
    };

    /// Layers of an element of a cantilever whose tip row carries `force` (N, along z).
    Seen bend(BladeParameters p, const double force, const unsigned int element, const std::vector<double> &layers)
    {
      p.mesh.n_span  = 14;
      p.mesh.n_chord = 4;
      for (int k = 0; k <= 4; ++k)
        p.loads.point_loads += (k > 0 ? " | 0.3112 " : "0.3112 ") + std::to_string(chord * (0.25 * k - 0.5)) +
                               " 0: 0; 0; " + std::to_string(force / (k % 4 == 0 ? 8. : 4.));
      ThreadPool      pool;
      const auto      blade = make_blade(p, pool);
      HistoryRequests requests;
      requests.axes = "blade";
      for (std::size_t k = 0; k < layers.size(); ++k)
        requests.elements += (k > 0 ? "; p" : "p") + std::to_string(k) + ": element " + std::to_string(element) +
                             " | " + std::to_string(layers[k]);
      const auto histories = blade->make_histories(requests);
      blade->find_equilibrium();
      Seen                seen;
      const auto         &table = *histories.tables.at(0);
      std::vector<double> row(table.columns.size());
      histories.tables[0]->follow();
      histories.tables[0]->fill(row);
      for (std::size_t k = 0; k < row.size(); ++k)
        {
          seen.value[table.columns[k].name]   = row[k];
          seen.meaning[table.columns[k].name] = table.columns[k].meaning;
        }
      return seen;
    }
  } // namespace

  // Hooke's law without stress across: e_nn = -nu/E (s_1 + s_2) at each layer, so that the compressed side grows
  // thicker; of the section's mean it was 0. Axes are those of the undeformed blade, from which the element has turned
  // by half a degree: squared and over nu 3e-4.
  TEST(ElementHistory, HasTheStrainAcrossALayerThatIsFree)
  {
    for (const bool has_thinning : {true, false})
      {
        BladeParameters p      = test::elastic_plate(14, 4);
        p.element.has_thinning = has_thinning;
        const auto now         = bend(p, 10., 30, {-1., 0.4, 1.}).value;
        for (const std::string place : {"p0", "p1", "p2"})
          {
            const double span = now.at(place + ".stress_span-span"), across = now.at(place + ".stress_chord-chord");
            const double free = -poisson / young * (span + across);
            EXPECT_NEAR(now.at(place + ".strain_normal-normal"), free, 5e-3 * std::abs(free)) << place << has_thinning;
            EXPECT_GT(std::abs(free), 5e-6);
          }
        EXPECT_LT(now.at("p0.strain_normal-normal") * now.at("p2.strain_normal-normal"), 0.);
      }
  }

  // Plastic flow keeps the volume: ln det F = (1 - 2 nu)/E tr s, whatever has flowed.
  TEST(ElementHistory, OfALayerThatFlowsKeepsTheVolume)
  {
    BladeParameters p    = test::elastic_plate(14, 4);
    p.material.hardening = "linear";
    p.material.yield     = "400e6";
    p.material.modulus   = "20e9";
    const auto now       = bend(p, 520., 2, {-1., 1.}).value;
    for (const std::string place : {"p0", "p1"})
      {
        double volume = 0., trace = 0.;
        for (const char *axis : {"span-span", "chord-chord", "normal-normal"})
          {
            volume += now.at(place + ".strain_" + axis);
            trace += now.at(place + ".stress_" + axis);
          }
        EXPECT_GT(now.at(place + ".plastic_strain"), 1e-3);
        EXPECT_NEAR(volume, (1. - 2. * poisson) / young * trace, 2e-5);
        EXPECT_GT(std::abs(volume), 1e-4);
        EXPECT_GT(std::abs(now.at(place + ".strain_normal-normal")), 1e-3);
      }
  }

  // Each ply is seen at the height that is asked for, whatever the points of metals: strain grows with it in a
  // symmetric stack, and stress is the ply's own stiffness (Jones 1999, eq. 2.61) times it, which jumps from one to
  // the next.
  TEST(ElementHistory, SeesEveryPlyAtItsOwnHeight)
  {
    const Ply           ply = laminate_case::carbon();
    BladeParameters     p   = test::elastic_plate(14, 4);
    std::vector<double> heights;
    p.laminate.plies   = "[0/90]4s";
    p.laminate.ply     = ply;
    p.element.n_points = 3;
    for (int k = 0; k < 16; ++k)
      heights.push_back((2. * k + 1.) / 16. - 1.);
    const auto   seen  = bend(p, 5., 30, heights);
    const double share = 1. - ply.poisson_12 * ply.poisson_12 * ply.young_2 / ply.young_1;
    const double slope = seen.value.at("p15.strain_span-span") / heights[15];
    EXPECT_GT(std::abs(slope), 1e-5);
    for (std::size_t k = 0; k < heights.size(); ++k)
      {
        const auto   of     = [&](const char *column) { return seen.value.at("p" + std::to_string(k) + column); };
        const double e_span = of(".strain_span-span"), e_chord = of(".strain_chord-chord");
        EXPECT_NEAR(e_span, slope * heights[k], 2e-3 * std::abs(slope)) << k;
        const bool   is_along = std::min<std::size_t>(k, 15 - k) % 2 == 0;
        const double expected =
          ((is_along ? ply.young_1 : ply.young_2) * e_span + ply.poisson_12 * ply.young_2 * e_chord) / share;
        EXPECT_NEAR(of(".stress_span-span"), expected, 5e-3 * std::abs(expected)) << k;
        EXPECT_NEAR(of(".strain_normal-normal"), 0., 1e-3 * std::abs(slope)) << "plies keep their thickness";
        EXPECT_NE(seen.meaning.at("p" + std::to_string(k) + ".stress_span-span")
                    .find("ply " + std::to_string(k + 1) + " of 16 from the bottom"),
                  std::string::npos);
      }
  }
} // namespace birdstrike::element_histories_test
