#include "blade_case.h"
#include "structure/deformable_blade.h"
#include "structure/histories/strain.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

// Histories of nodes, elements and gauges.
namespace birdstrike::histories_test
{
  namespace
  {
    constexpr double length = 0.3112, chord = 0.0889, thickness = 0.00427, young = 113.8e9;

    std::map<std::string, double> values_of(const BladeHistories &histories)
    {
      std::map<std::string, double> values;
      for (const auto &table : histories.tables)
        {
          std::vector<double> row(table->columns.size());
          table->fill(row);
          for (std::size_t k = 0; k < row.size(); ++k)
            {
              EXPECT_NE(table->columns[k].meaning, "");
              values[table->columns[k].name] = row[k];
            }
        }
      return values;
    }

    void follow(const BladeHistories &histories)
    {
      for (const auto &table : histories.tables)
        table->follow();
    }

    // Pure logarithmic strain, turned: R ln(U) R^T whatever the rotation.
    TEST(Strain, IsLogarithmicAndTurnsWithTheBody)
    {
      const Matrix3<double> R = Eigen::AngleAxisd(2.5, Point3(1., 2., -0.5).normalized()).toRotationMatrix();
      const Point3          stretch(1.2, 0.9, 1.05);
      const Matrix3<double> U = stretch.asDiagonal(), F = R * U;
      const Matrix3<double> E = R * Matrix3<double>(stretch.array().log().matrix().asDiagonal()) * R.transpose();
      const auto            e = logarithmic_strain(F);
      const double          expected[6] = {E(0, 0), E(1, 1), E(2, 2), E(0, 1), E(1, 2), E(2, 0)};
      for (int k = 0; k < 6; ++k)
        EXPECT_NEAR(e[k], expected[k], 1e-14);
    }

    // A support that follows A sin^2(w t): its node has the formula's velocity and acceleration. The velocity is the
    // central difference over a step (1 us): (w dt)^2 = 1e-6 of it.
    TEST(NodeHistory, HasTheAccelerationOfADrivenSupport)
    {
      BladeParameters p = test::elastic_plate(14, 4);
      p.supports.driven = "1: uz = 1e-3*sin(1000*t)^2";
      ThreadPool      pool;
      const auto      blade = make_blade(p, pool);
      HistoryRequests requests;
      requests.nodes       = "tip: 0.3112 0 0";
      const auto histories = blade->make_histories(requests);
      EXPECT_TRUE(histories.warnings.empty());
      const double dt = 1e-6;
      test::advance(*blade, dt, 700);
      const auto   now = values_of(histories);
      const double t = 700 * dt, A = 1e-3, w = 1000.;
      EXPECT_EQ(now.size(), 9u);
      EXPECT_NEAR(now.at("tip.u_z"), A * std::pow(std::sin(w * t), 2), 1e-9 * A);
      EXPECT_NEAR(now.at("tip.v_z"), A * w * std::sin(2. * w * t), 1e-5 * A * w);
      EXPECT_NEAR(now.at("tip.a_z"), 2. * A * w * w * std::cos(2. * w * t), 1e-4 * A * w * w);
    }

    // A formula need not have values before the motion begins: the root at t - h is none. At t = 0 the acceleration is
    // 10 m/s^2; of t^(7/2) the difference makes h^(3/2) (-5 + 4 2^(7/2) - 3^(7/2)) = -6.5e-9 at h = 1 us, and round-off
    // is 8 * 1e-16 * 4.5e-11/h^2 = 4e-14.
    TEST(NodeHistory, AsksNoFormulaForTheTimeBefore0)
    {
      BladeParameters p = test::elastic_plate(14, 4);
      p.supports.driven = "1: uz = 5*t^2 + t^3*sqrt(t)";
      ThreadPool      pool;
      const auto      blade = make_blade(p, pool);
      HistoryRequests requests;
      requests.nodes       = "tip: 0.3112 0 0";
      const auto histories = blade->make_histories(requests);
      EXPECT_NEAR(values_of(histories).at("tip.a_z"), 10., 1e-7);
    }

    // The force on a free node over its mass is what its velocity does: (v(t+dt) - v(t-dt))/(2 dt), to second order in
    // the step. And components in other axes are those of the same vectors.
    TEST(NodeHistory, HasTheAccelerationThatTheVelocityTakes)
    {
      BladeParameters p        = test::elastic_plate(14, 4);
      p.loads.initial_velocity = "0; 0; 5*(x/0.3112)^2";
      p.loads.damping          = 2000.;
      ThreadPool      pool;
      const auto      blade = make_blade(p, pool);
      HistoryRequests requests;
      requests.nodes      = "mid: 0.1556 0 0";
      const auto global   = blade->make_histories(requests);
      requests.axes       = "blade";
      const auto local    = blade->make_histories(requests);
      requests.axes       = "0 0 1 0 1 0";
      const auto   turned = blade->make_histories(requests);
      const double dt     = 0.1 * blade->step_limit().value;
      test::advance(*blade, dt, 2000);
      const double before = values_of(global).at("mid.v_z");
      test::advance(*blade, dt, 1);
      const auto now = values_of(global);
      EXPECT_EQ(values_of(local).at("mid.a_normal"), now.at("mid.a_z"));
      EXPECT_EQ(values_of(local).at("mid.u_span"), now.at("mid.u_x"));
      EXPECT_EQ(values_of(turned).at("mid.a_1"), now.at("mid.a_z"));
      EXPECT_EQ(values_of(turned).at("mid.a_3"), -now.at("mid.a_x"));
      test::advance(*blade, dt, 1);
      const double after = values_of(global).at("mid.v_z");
      EXPECT_NEAR((after - before) / (2. * dt), now.at("mid.a_z"), 2e-2 * std::abs(now.at("mid.a_z")));
      EXPECT_GT(std::abs(now.at("mid.a_z")), 100.);
    }

    // Two squares whose nodes and elements have numbers of their own: places go by these, and fields show them.
    TEST(Histories, NumbersAreThoseOfTheFile)
    {
      std::string   pattern = (std::filesystem::temp_directory_path() / "birdstrike-XXXXXX").string() + ".inp";
      const int     file    = ::mkstemps(pattern.data(), 4);
      std::ofstream out(pattern);
      ::close(file);
      out << "*NODE\n11, 0, 0, 0\n2, 0.1, 0, 0\n40, 0.2, 0, 0\n5, 0, 0.1, 0\n1, 0.1, 0.1, 0\n7, 0.2, 0.1, 0\n"
          << "*ELEMENT, TYPE=S4R, ELSET=blade\n1, 2, 40, 7, 1\n900, 11, 2, 1, 5\n*NSET, NSET=root\n11, 5\n";
      out.close();
      BladeParameters p  = test::elastic_plate(1, 1);
      p.mesh.generator   = MeshGenerator::file;
      p.mesh.file        = pattern;
      p.supports.clamped = "root";
      ThreadPool      pool;
      const auto      blade = make_blade(p, pool);
      HistoryRequests requests;
      requests.nodes                             = "a: node 1; b: node 40";
      requests.elements                          = "c: element 1; d: element 900; e: 0.01 0.05 0";
      const auto                         written = blade->make_histories(requests);
      std::map<std::string, std::string> meaning;
      for (const auto &table : written.tables)
        for (const Column &column : table->columns)
          meaning[column.name] = column.meaning;
      const auto tells = [&](const char *column, const char *what) {
        return meaning.at(column).find(what) != std::string::npos;
      };
      EXPECT_TRUE(tells("a.u_x", "node 1 at (0.1, 0.1, 0) m")) << meaning.at("a.u_x");
      EXPECT_TRUE(tells("b.u_x", "node 40 at (0.2, 0, 0) m"));
      EXPECT_TRUE(tells("c.plastic_strain", "element 1 at (0.15, 0.05, 0) m"));
      EXPECT_TRUE(tells("d.plastic_strain", "element 900 at (0.05, 0.05, 0) m"));
      EXPECT_TRUE(tells("e.plastic_strain", "element 900 at"));
      requests.nodes = "a: node 0"; // a place of the program's own lists
      EXPECT_THROW(blade->make_histories(requests), InputError);
      requests          = {};
      requests.elements = "a: element 2";
      EXPECT_THROW(blade->make_histories(requests), InputError);
      const FieldSnapshot snapshot = blade->snapshot();
      for (const auto &[name, numbers] :
           {std::pair("node", std::set<double>{11, 2, 40, 5, 1, 7}), std::pair("element", std::set<double>{1, 900})})
        {
          const auto field = std::ranges::find(snapshot.fields, std::string(name), &Field::name);
          EXPECT_EQ(std::set<double>(field->values.begin(), field->values.end()), numbers) << name;
        }
      std::filesystem::remove(pattern);
    }

    TEST(Histories, SayWhatTheMeshDoesNotHave)
    {
      ThreadPool      pool;
      const auto      blade = make_blade(test::elastic_plate(14, 4), pool);
      HistoryRequests requests;
      requests.nodes       = "near: 0.1 0.01 0; far: 0.1 0 0.03";
      const auto histories = blade->make_histories(requests);
      ASSERT_EQ(histories.warnings.size(), 1u);
      EXPECT_EQ(histories.warnings[0].code, "history/far_from_mesh");
      EXPECT_NE(histories.warnings[0].text.find("'far' at (0.1, 0, 0.03) m"), std::string::npos);
      const auto refuses = [&](std::string HistoryRequests::*entry, const char *text) {
        HistoryRequests bad;
        bad.*entry = text;
        EXPECT_THROW(blade->make_histories(bad), InputError) << text;
      };
      // the box of 0.3112 x 0.0889 m is 0.3236 m from corner to corner: 0.033 m are a tenth of it, 0.4 mm in mm not
      for (const auto entry : {&HistoryRequests::nodes, &HistoryRequests::elements, &HistoryRequests::gauges})
        for (const char *text : {"a: 0.1 0 0.033", "a: 400 0 0"})
          refuses(entry, text);
      BladeParameters probed = test::elastic_plate(14, 4);
      probed.probes          = "a: 400 0 0";
      EXPECT_THROW(make_blade(probed, pool), InputError);
      for (const char *text : {"a: node 75", "a: 1 2", "a.b: 0 0 0", "a: 0 0 0; a: 0 0 0"})
        refuses(&HistoryRequests::nodes, text);
      for (const char *text : {"a: element 56", "a: 0 0 0 | 1.5", "a: 0 0 0 | 0 | 0"})
        refuses(&HistoryRequests::elements, text);
      for (const char *text : {"a: 0 0 0 | span | back", "a: 0 0 0 | 0 0 1", "a: 0 0 0 | x"})
        refuses(&HistoryRequests::gauges, text);
      for (const char *text : {"1", "-0.1", "half", "0.999"})
        refuses(&HistoryRequests::stations, text);
      BladeParameters rigid;
      rigid.kind      = BladeKind::rigid;
      requests        = {};
      requests.gauges = "a: 0 0 0";
      EXPECT_THROW(make_blade(rigid, pool)->make_histories(requests), InputError);
    }

    /// A cantilever without lateral strain under 10 N at its tip, at rest after critical damping.
    struct Cantilever
    {
      ThreadPool             pool;
      std::unique_ptr<Blade> blade;
      BladeHistories         histories;

      Cantilever(const BladeKind kind, const HistoryRequests &requests)
      {
        BladeParameters p  = test::elastic_plate(28, 4);
        p.kind             = kind;
        p.material.poisson = "0";
        p.loads.damping    = 460.;
        for (int k = 0; k <= 4; ++k)
          for (const double z : kind == BladeKind::solid ? std::vector<double>{-0.5 * thickness, 0.5 * thickness}
                                                         : std::vector<double>{0.})
            p.loads.point_loads += (p.loads.point_loads.empty() ? "" : " | ") + std::to_string(length) + " " +
                                   std::to_string(chord * (0.25 * k - 0.5)) + " " + std::to_string(z) + ": 0; 0; " +
                                   std::to_string((k % 4 == 0 ? 1.25 : 2.5) / (kind == BladeKind::solid ? 2. : 1.));
        blade           = make_blade(p, pool);
        histories       = blade->make_histories(requests);
        const double dt = 0.9 * blade->largest_stable_step();
        for (unsigned int step = 0; step < 0.07 / dt; ++step)
          {
            test::advance(*blade, dt, 1);
            follow(histories);
          }
      }

      /// Of the face away from +z, by beam theory.
      static double strain(const double x)
      {
        return 10. * (length - x) * 0.5 * thickness / (young * chord * std::pow(thickness, 3) / 12.);
      }
    };

    constexpr double middle = (7 + 0.5) * length / 28; // of an element, along the span

    // e = M t/(2 E I) at the middle of an element, where it is exact for a linear moment; free edges bend as a beam
    // without lateral strain. The tip moves by 1.5 mm, strain is 7e-5: engineering and logarithmic are one. 0.5 %.
    TEST(Gauges, OfACantileverReadTheStrainOfBeamTheory)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
        {
          HistoryRequests requests;
          const auto      at = std::to_string(middle) + " 0.01 0";
          requests.gauges    = "struck: " + at + "; other: " + at + " | span | other; chord: " + at +
                            " | chord; diagonal: " + at + " | 45; vector: " + at + " | -1 0 0";
          const Cantilever cantilever(kind, requests);
          const auto       now = values_of(cantilever.histories);
          const double     e   = Cantilever::strain(middle);
          EXPECT_NEAR(now.at("struck.strain"), e, 5e-3 * e);
          EXPECT_NEAR(now.at("other.strain"), -e, 5e-3 * e);
          EXPECT_NEAR(now.at("vector.strain"), e, 5e-3 * e);
          EXPECT_NEAR(now.at("diagonal.strain"), 0.5 * e, 5e-3 * e);
          EXPECT_NEAR(now.at("chord.strain"), 0., 5e-3 * e);
        }
    }

    // The same in stress, strain and what follows from them. Of the shell at its integration points, of the brick at
    // its faces and its middle.
    TEST(ElementHistory, OfACantileverIsThatOfBeamTheory)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
        {
          HistoryRequests requests;
          const auto      at = std::to_string(middle) + " 0.01 0";
          requests.axes      = "blade";
          requests.elements  = "low: " + at + " | -1; mid: " + at + "; high: " + at + " | 1";
          const Cantilever cantilever(kind, requests);
          auto             now = values_of(cantilever.histories);
          // the outermost of seven Gauss points
          const double e = Cantilever::strain(middle) * (kind == BladeKind::shell ? 0.949107912342759 : 1.);
          for (const auto &[name, sign] : {std::pair("low", 1.), std::pair("high", -1.)})
            {
              const std::string place = name;
              EXPECT_NEAR(now[place + ".strain_span-span"], sign * e, 5e-3 * e);
              EXPECT_NEAR(now[place + ".stress_span-span"], sign * young * e, 5e-3 * young * e);
              EXPECT_NEAR(now[place + ".stress_chord-chord"], 0., 5e-3 * young * e);
              EXPECT_NEAR(now[place + ".von_mises"], young * e, 1e-2 * young * e);
              EXPECT_NEAR(now[place + ".triaxiality"], sign / 3., 1e-2);
            }
          EXPECT_NEAR(now["mid.strain_span-span"], 0., 5e-3 * e);
          EXPECT_EQ(now["mid.plastic_strain"], 0.);
          EXPECT_EQ(now["mid.failed"], 0.);
          if (kind == BladeKind::shell)
            {
              EXPECT_NEAR(now["mid.thickness"], thickness, 1e-6 * thickness);
            }
        }
    }

    // Nothing that is looked at changes: bitwise the same motion.
    TEST(Histories, DoNotChangeTheMotion)
    {
      const auto run = [](const bool has_histories) {
        BladeParameters p        = test::elastic_plate(14, 4);
        p.loads.initial_velocity = "0; 0; 50*(x/0.3112)^2 + 30*x*y";
        ThreadPool      pool;
        ShellBlade      blade(p, pool);
        HistoryRequests requests;
        if (has_histories)
          requests = {"blade", "a: node 3", "a: element 3 | 1", "a: 0.1 0 0", "0, 0.5", ""};
        const auto   histories = blade.make_histories(requests);
        const double dt        = 0.8 * blade.step_limit().value;
        for (int step = 0; step < 50; ++step)
          {
            test::advance(blade, dt, 1);
            follow(histories);
            values_of(histories);
          }
        const auto nodes = blade.nodes();
        return std::vector<double>(nodes.velocity, nodes.velocity + 6 * nodes.n);
      };
      EXPECT_TRUE(test::is_bitwise_equal(run(false), run(true)));
    }
  } // namespace
} // namespace birdstrike::histories_test
