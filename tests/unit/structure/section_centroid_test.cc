#include "blade_case.h"

#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/roles.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <map>

#include <fmt/format.h>

// Moments of sections are about the point where a tension bends nothing.
namespace birdstrike::section_centroid_test
{
  namespace
  {
    constexpr double       length = 0.3, chord = 0.1, thick = 0.006, thin = 0.002, young = 113.8e9;
    constexpr unsigned int n_chord = 8;

    /// Straight along the span, an arc of 10 mm across it; the middle half of the chord is three times as thick as the
    /// edges, or has three times their modulus.
    BladeParameters cambered(const bool has_two_metals)
    {
      BladeParameters p     = test::elastic_plate(6, n_chord);
      p.mesh.generator      = MeshGenerator::blade;
      p.mesh.length         = length;
      p.mesh.chord          = chord;
      p.mesh.profile.camber = "0.1";
      p.material.poisson    = "0";
      p.thickness.value     = has_two_metals ? "0.002" : "if(abs(y) < 0.025, 0.006, 0.002)";
      if (has_two_metals)
        {
          p.mesh.material_boxes        = "-1 -0.025 -1 1 0.025 1: 7";
          p.sections[0].material_ids   = "7";
          p.sections[0].material       = p.material;
          p.sections[0].material.young = std::to_string(3. * young);
        }
      return p;
    }

    /// The root of its mesh and what its edges carry of a tension, half of it at either node.
    struct Line
    {
      std::map<std::uint32_t, double> share;
      Point3                          middle = Point3::Zero(), centroid = Point3::Zero();
    };

    Line line_of(const ShellMesh &mesh, const unsigned int id)
    {
      Line   line;
      double sum = 0., size = 0.;
      for (const auto &edge : mesh.boundary)
        if (edge.id == id)
          {
            const Point3 a = mesh.node(edge.nodes[0]), b = mesh.node(edge.nodes[1]), at = 0.5 * (a + b);
            const double l = (b - a).norm(), carries = l * (std::abs(at[1]) < 0.025 ? thick : thin);
            size += l;
            sum += carries;
            line.middle += l * at;
            line.centroid += carries * at;
            for (const std::uint32_t n : edge.nodes)
              line.share[n] += 0.5 * carries;
          }
      line.middle /= size;
      line.centroid /= sum;
      for (auto &[node, share] : line.share)
        share /= sum;
      return line;
    }

    std::map<std::string, double> values_of(const BladeHistories &histories)
    {
      std::map<std::string, double> values;
      for (const auto &table : histories.tables)
        {
          std::vector<double> row(table->columns.size());
          table->fill(row);
          for (std::size_t k = 0; k < row.size(); ++k)
            values[table->columns[k].name] = row[k];
        }
      return values;
    }
  } // namespace

  // A tension that is spread over the tip as E t strains a straight blade without lateral strain evenly: a state of
  // membranes that elements have exactly, without any bending. About the plain middle of the line it would have the
  // moment N e = 1000 N * 1.26 mm. Round-off of the equilibrium: its residual is 1e-9 of the loads or less, 1e-6 of N
  // e.
  TEST(SectionCentroid, TensionHasNoMoment)
  {
    for (const bool has_two_metals : {false, true})
      {
        BladeParameters p = cambered(has_two_metals);
        const ShellMesh mesh(p);
        const Line      tip = line_of(mesh, 1);
        const double    arm = (tip.centroid - tip.middle).norm();
        EXPECT_NEAR(arm, 1.26e-3, 0.01e-3);
        for (const auto &[node, share] : tip.share)
          {
            const Point3 x = mesh.node(node);
            p.loads.point_loads += fmt::format("{}{:.17g} {:.17g} {:.17g}: {:.17g}; 0; 0",
                                               p.loads.point_loads.empty() ? "" : " | ", x[0], x[1], x[2], 1e3 * share);
          }
        ThreadPool pool;
        const auto blade = make_blade(p, pool);
        blade->find_equilibrium();
        const RootSectionReport root = blade->root_section();
        EXPECT_NEAR(root.normal_force, 1e3, 1e-6);
        EXPECT_NEAR(root.bending_moment, 0., 1e-6 * 1e3 * arm) << has_two_metals;
        HistoryRequests requests;
        requests.stations = "0,0.5";
        const auto now    = values_of(blade->make_histories(requests));
        for (const std::string station : {"span0", "span0.5"})
          {
            EXPECT_NEAR(now.at(station + ".N"), 1e3, 1e-6);
            for (const char *moment : {".M_bending", ".M_edgewise", ".M_torsion"})
              EXPECT_NEAR(now.at(station + moment), 0., 1e-6 * 1e3 * arm) << station << moment << has_two_metals;
          }
      }
  }

  // What lies across the chord from the middle: half of it three times as stiff, (3 - 1)/(3 + 1) * chord/4. The axes of
  // a flat root stay.
  TEST(SectionCentroid, OfARootIsThatOfItsStiffness)
  {
    BladeParameters     p = test::elastic_plate(3, 4);
    const ShellMesh     mesh(p);
    std::vector<double> stiffness;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      stiffness.push_back(mesh.centroid(cell)[1] > 0. ? 3e8 : 1e8);
    const BladeRoles roles(mesh, {0}, {1}, {}, stiffness), plain(mesh, {0}, {1}, {});
    EXPECT_LT((roles.root.centroid - Point3(0., p.mesh.chord / 8., 0.)).norm(), 1e-15);
    EXPECT_LT((plain.root.centroid - plain.root.middle).norm(), 1e-15);
    EXPECT_LT((roles.root.middle - plain.root.middle).norm(), 1e-15) << "of the line";
    EXPECT_LT((roles.root.normal - plain.root.normal).norm(), 1e-15);
    EXPECT_LT((roles.root.span - plain.root.span).norm(), 1e-15);
  }
} // namespace birdstrike::section_centroid_test
