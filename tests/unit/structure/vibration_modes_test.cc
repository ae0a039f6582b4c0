#include "../record.h"
#include "blade_case.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <map>

namespace birdstrike::vibration_modes_test
{
  namespace
  {
    VibrationModes modes_of(const BladeParameters &p, const std::size_t n)
    {
      ThreadPool pool(1);
      const auto blade = make_blade(p, pool);
      blade->find_equilibrium();
      return blade->compute_modes(n);
    }

    /// 1 m x 20 mm x 5 mm of steel on a hub without size, which turns about the normal; w^2 = x^4 E I/(rho A L^4).
    BladeParameters beam(const char *kind)
    {
      BladeParameters p  = test::elastic_plate(60, 2);
      p.kind             = blade_kinds().at(kind);
      p.mesh.length      = 1.;
      p.mesh.chord       = 0.02;
      p.thickness.value  = "0.005";
      p.material.density = "7800";
      p.material.young   = "200e9";
      p.material.poisson = "0";
      return p;
    }
  } // namespace

  // The plate of benchmark A4: Mindlin's plate by Ritz' method, converged
  // (tests/verification/reference/a1_plate_modes.py).
  TEST(VibrationModes, AreThoseOfMindlinsPlate)
  {
    constexpr std::array<double, 6> mindlin{{36.863, 230.15, 254.00, 645.67, 791.08, 1268.3}};
    for (const char *kind : {"shell", "solid"})
      {
        BladeParameters p    = test::elastic_plate(56, 16);
        p.kind               = blade_kinds().at(kind);
        VibrationModes found = modes_of(p, 7);
        // the fifth is in the plane: nearly all of its mass moves along the chord
        EXPECT_GT(found.modes[4].effective_mass[1], 0.5) << kind;
        found.modes.erase(found.modes.begin() + 4);
        record(std::string(kind) + " first torsion", found.modes[2].frequency);
        record(std::string(kind) + " fourth bending", found.modes[5].frequency);
        for (std::size_t k = 0; k < mindlin.size(); ++k)
          EXPECT_NEAR(found.modes[k].frequency / mindlin[k], 1., k == 2 || k == 4 ? 2e-3 : 1e-3) << kind << k;
      }
  }

  // Flapping of a rotating cantilever: Wright, Smith, Thresher & Wang 1982, table 1, hub radius 0; eta = Omega over the
  // unit of frequency. Rotary inertia and shear take 1e-4 of the first and 2e-3 of the third.
  TEST(VibrationModes, AreThoseOfARotatingBeam)
  {
    struct Row
    {
      double                eta;
      std::array<double, 3> flap;
    };
    constexpr std::array<Row, 4> table{{{0., {3.5160, 22.0345, 61.6972}},
                                        {3., {4.7973, 23.3203, 62.9850}},
                                        {6., {7.3604, 26.8091, 66.6840}},
                                        {12., {13.1702, 37.6031, 79.6145}}}};
    for (const char *kind : {"shell", "solid"})
      for (const Row &row : table)
        {
          BladeParameters p    = beam(kind);
          const double    unit = std::sqrt(200e9 / (12. * 7800.)) * 0.005;
          p.spin.speed         = std::to_string(row.eta * unit);
          std::size_t k        = 0;
          for (const auto &mode : modes_of(p, 5).modes)
            if (mode.effective_mass[2] > 0.01 && k < 3) // the others are in the plane of rotation
              {
                record(std::string(kind) + " eta " + std::to_string(int(row.eta)) + " flap " + std::to_string(k + 1),
                       2. * M_PI * mode.frequency / unit);
                EXPECT_NEAR(2. * M_PI * mode.frequency / unit / row.flap[k], 1., k < 2 ? 1e-3 : 2.5e-3)
                  << kind << " eta " << row.eta << " mode " << k;
                ++k;
              }
          EXPECT_EQ(k, 3u);
        }
  }

  // Six motions of a free body store nothing; the others are those of the free plate, none of them an hourglass or a
  // drilling mode at zero.
  TEST(VibrationModes, HaveSixZerosWhereNothingHolds)
  {
    for (const char *kind : {"shell", "solid"})
      {
        BladeParameters p = test::free_plate(40, 12);
        p.kind            = blade_kinds().at(kind);
        const auto found  = modes_of(p, 8).modes;
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_LT(std::abs(found[k].frequency), 0.05) << kind;
        // free and free, a beam's first is 4.7300^2/(2 pi L^2) sqrt(E h^2/(12 rho)); a plate is a little stiffer
        const double beam =
          4.73004 * 4.73004 / (2. * M_PI * 0.3112 * 0.3112) * std::sqrt(113.8e9 / (12. * 4430.)) * 0.00427;
        EXPECT_GT(found[6].frequency / beam, 0.99) << kind;
        EXPECT_LT(found[6].frequency / beam, 1.03) << kind;
      }
  }

  // Shell and solid shake alike: shapes at the nodes of the shell, and the mean of both faces of the solid there.
  TEST(VibrationModes, AreAlikeOfShellAndSolid)
  {
    std::array<VibrationModes, 2>                   found;
    std::array<std::vector<std::vector<double>>, 2> shapes; // by mode, at the columns of nodes in the order of x and y
    for (const std::size_t i : {0, 1})
      {
        BladeParameters p = test::elastic_plate(40, 12);
        p.kind            = i == 0 ? BladeKind::shell : BladeKind::solid;
        ThreadPool pool(1);
        const auto blade                                               = make_blade(p, pool);
        found[i]                                                       = blade->compute_modes(5);
        const auto                                              points = blade->snapshot().points;
        std::map<std::array<long, 2>, std::vector<std::size_t>> columns;
        for (std::size_t n = 0; n < points.size(); n += 3)
          columns[{std::lround(1e6 * points[n]), std::lround(1e6 * points[n + 1])}].push_back(n);
        for (const auto &mode : found[i].modes)
          {
            std::vector<double> &shape = shapes[i].emplace_back();
            for (const auto &[place, nodes] : columns)
              for (unsigned int d = 0; d < 3; ++d)
                {
                  double sum = 0.;
                  for (const std::size_t n : nodes)
                    sum += mode.shape[n + d];
                  shape.push_back(sum / static_cast<double>(nodes.size()));
                }
          }
      }
    for (std::size_t k = 0; k < 5; ++k)
      {
        EXPECT_GT(modal_assurance(shapes[0][k], shapes[1][k]), 0.999) << k;
        EXPECT_NEAR(found[0].modes[k].frequency / found[1].modes[k].frequency, 1., 0.01) << k;
      }
  }

  // What has yielded unloads and vibrates elastically: a stub that bends by a tenth of its length has the modes of one
  // that never yields under the same load. By the tangent in flow the first is 7 to 14 % lower.
  TEST(VibrationModes, AboutAStateThatYieldsAreElastic)
  {
    for (const auto &[kind, formulation] :
         {std::pair("shell", "physical"), std::pair("shell", "fully integrated"), std::pair("shell", "Belytschko-Tsay"),
          std::pair("solid", "solid-shell"), std::pair("solid", "one point"), std::pair("solid", "B-bar")})
      {
        const auto stub = [&, kind = kind, formulation = formulation](const char *hardening) {
          BladeParameters p     = test::elastic_plate(12, 4);
          p.kind                = blade_kinds().at(kind);
          p.element.formulation = element_formulations().at(formulation);
          p.mesh.n_layers       = p.kind == BladeKind::solid && std::string(formulation) != "solid-shell" ? 4 : 1;
          p.mesh.length         = 0.3;
          p.mesh.chord          = 0.1;
          p.thickness.value     = "0.02";
          p.material.hardening  = hardening;
          p.material.yield      = "400e6";
          p.material.modulus    = "10e9";
          p.loads.pressure = p.mesh.n_layers == 4 ? "1.25e6" : "0.9e6"; // the outer bricks are nearer to the middle
          ThreadPool pool(1);
          const auto blade = make_blade(p, pool);
          blade->find_equilibrium();
          const auto modes = blade->compute_modes(3).modes;
          EXPECT_EQ(blade->peak_plastic_strains().at(0).value > 1e-4, hardening == std::string("linear"))
            << formulation;
          const auto again = blade->compute_modes(3).modes;
          EXPECT_NEAR(again[0].frequency / modes[0].frequency, 1., 1e-9) << "the state is as it was";
          return modes;
        };
        const auto yielded = stub("linear"), elastic = stub("elastic");
        for (std::size_t k = 0; k < 3; ++k)
          {
            record(std::string(formulation) + " " + std::to_string(k), yielded[k].frequency / elastic[k].frequency);
            EXPECT_NEAR(yielded[k].frequency / elastic[k].frequency, 1., 5e-3) << formulation << k;
          }
      }
  }

  TEST(VibrationModes, RefuseMoreThanThereAre)
  {
    EXPECT_THROW(modes_of(test::elastic_plate(2, 1), 100), InputError);
    BladeParameters rigid;
    rigid.kind = BladeKind::rigid;
    ThreadPool pool(1);
    EXPECT_THROW(make_blade(rigid, pool)->compute_modes(1), InputError);
    EXPECT_THROW(make_blade(rigid, pool)->find_equilibrium(), InputError);
  }
} // namespace birdstrike::vibration_modes_test
