#include "../mesh/temporary_mesh.h"
#include "blade_case.h"
#include "frequencies.h"
#include "oriented_file.h"

#include "structure/deformable_blade.h"
#include "structure/rigid_plate.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace birdstrike::symmetry_plane_test
{
  namespace
  {
    using test::advance;
    using test::elastic_plate;
    using test::natural_frequencies;

    /// A plate that bends along both directions, stretches and yields at the root, symmetrically about y = 0.
    BladeParameters struck_plate(const bool is_halved, const std::string &formulation = "physical")
    {
      BladeParameters p        = elastic_plate(14, 6);
      p.element.formulation    = element_formulations().at(formulation);
      p.material.hardening     = "perfect";
      p.is_halved              = is_halved;
      p.loads.pressure         = "-2e6*exp(-(x-0.2)^2/0.001-y^2/0.0005)";
      p.loads.initial_velocity = "-20*x; 300*y; -200*(x/0.3)^2*(1-300*y^2)";
      return p;
    }

    using Place = std::array<double, 3>;

    std::map<Place, std::size_t> nodes_by_place(ShellBlade &blade)
    {
      const auto                   nodes = blade.nodes();
      std::map<Place, std::size_t> result;
      for (std::size_t n = 0; n < nodes.n; ++n)
        result[{{std::round(1e9 * nodes.reference[3 * n]), std::round(1e9 * nodes.reference[3 * n + 1]), 0.}}] = n;
      return result;
    }
  } // namespace

  TEST(SymmetryPlane, HalfAPlateMovesLikeTheWhole)
  {
    for (const std::string formulation : {"physical", "fully integrated"})
      {
        SCOPED_TRACE(formulation);
        ThreadPool pool;
        ShellBlade whole(struck_plate(false, formulation), pool), half(struck_plate(true, formulation), pool);
        EXPECT_EQ(half.n_elements(), whole.n_elements());
        EXPECT_EQ(half.n_nodes(), whole.n_nodes());
        EXPECT_NEAR(half.mass() / whole.mass(), 1., 1e-14);
        const double dt = 0.8 * whole.step_limit().value;
        EXPECT_NEAR(half.step_limit().value / whole.step_limit().value, 1., 1e-12);
        advance(whole, dt, 600);
        advance(half, dt, 600);

        const auto a = whole.nodes(), b = half.nodes();
        const auto place  = nodes_by_place(whole);
        double     length = 0., turn = 0., largest[2] = {0., 0.};
        for (const auto &[where, n] : nodes_by_place(half))
          for (unsigned int c = 0; c < 6; ++c)
            {
              const double u = a.displacement[6 * place.at(where) + c], error = std::abs(u - b.displacement[6 * n + c]);
              (c < 3 ? length : turn) = std::max(c < 3 ? length : turn, std::abs(u));
              largest[c / 3]          = std::max(largest[c / 3], error);
            }
        EXPECT_GT(length, 0.005);
        EXPECT_LT(largest[0], 1e-10 * length);
        EXPECT_LT(largest[1], 1e-10 * turn);
        EXPECT_GT(half.energies().plastic, 1.);
        EXPECT_NEAR(half.energies().total() / whole.energies().total(), 1., 1e-10);
      }
  }

  TEST(SymmetryPlane, HalfASectionReportsTheWhole)
  {
    ThreadPool   pool;
    ShellBlade   whole(struck_plate(false), pool), half(struck_plate(true), pool);
    const double dt = 0.8 * whole.step_limit().value;
    advance(whole, dt, 400);
    advance(half, dt, 400);
    const auto w = whole.root_section(), h = half.root_section();
    EXPECT_NEAR(h.bending_moment / w.bending_moment, 1., 1e-9);
    EXPECT_NEAR(h.normal_force / w.normal_force, 1., 1e-9);
    EXPECT_NEAR(h.transverse_force / w.transverse_force, 1., 1e-9);
    EXPECT_NEAR(h.peak_stress() / w.peak_stress(), 1., 1e-9);
    ASSERT_EQ(h.chord_position.size(), 3u);
    for (unsigned int k = 0; k < 3; ++k)
      EXPECT_NEAR(h.chord_position[k], w.chord_position[3 + k], 1e-12) << "from the middle of the whole edge";
    EXPECT_NEAR(h.stress_rear[0] / w.stress_rear[3], 1., 1e-9);
    const auto t = whole.tip_deflection(), s = half.tip_deflection();
    EXPECT_NEAR(s.mid_chord / t.mid_chord, 1., 1e-9);
    EXPECT_NEAR(s.leading / t.leading, 1., 1e-9);
    EXPECT_NEAR(s.trailing / t.trailing, 1., 1e-9);
  }

  // Cambered and swept like an arrow, from files: the axes of the whole's root, tip and sections lie in the plane,
  // those of the half's cells alone do not.
  TEST(SymmetryPlane, HalfABladeFromAFileHasTheAxesOfTheWhole)
  {
    constexpr double chord = 0.0889;
    for (const unsigned int n_layers : {0u, 2u})
      {
        SCOPED_TRACE(n_layers);
        std::vector<std::map<std::string, double>> found;
        for (const bool is_halved : {false, true})
          {
            test::Listing listing;
            listing.corners = [&] {
              return n_layers > 0 ? std::vector<unsigned int>{0, 1, 2, 3, 4, 5, 6, 7}
                                  : std::vector<unsigned int>{0, 1, 2, 3};
            };
            listing.shape = [&](const Point3 &x) {
              const double y = is_halved ? 0.5 * (x[1] + 0.5 * chord) : x[1];
              return Point3(x[0] + 0.5 * std::abs(y), y, x[2] + 0.015 * (1. - 4. * y * y / (chord * chord)));
            };
            const test::PlateFile file({{14, is_halved ? 3u : 6u, n_layers}}, listing);
            BladeParameters       p  = file.parameters();
            p.is_halved              = is_halved;
            p.loads.initial_velocity = "0; 0; -20*(x/0.3)^2";
            ThreadPool      pool;
            const auto      blade = make_blade(p, pool);
            HistoryRequests requests;
            requests.axes        = "blade";
            requests.nodes       = "mid: 0.1556 0 0.015";
            requests.stations    = "0, 0.5";
            const auto histories = blade->make_histories(requests);
            advance(*blade, 2e-7, 600);
            auto      &values = found.emplace_back();
            const auto root   = blade->root_section();
            const auto tip    = blade->tip_deflection();
            values            = {{"moment", root.bending_moment},
                                 {"normal", root.normal_force},
                                 {"transverse", root.transverse_force},
                                 {"tip", tip.mid_chord},
                                 {"leading", tip.leading}};
            for (const auto &table : histories.tables)
              {
                table->follow();
                std::vector<double> row(table->columns.size());
                table->fill(row);
                for (std::size_t k = 0; k < row.size(); ++k)
                  values[table->columns[k].name] = row[k];
              }
          }
        ASSERT_EQ(found[0].size(), found[1].size());
        EXPECT_GT(std::abs(found[0].at("moment")), 1.);
        // of components the largest is the scale: u, v and a of the node, forces and moments of the stations
        const auto group_of = [](const std::string &name) {
          return name.find(".M_") != std::string::npos        ? std::string("M")
                 : name.find("span") < name.find_last_of('.') ? std::string("F")
                                                              : name.substr(0, name.rfind('_'));
        };
        std::map<std::string, double> scale;
        for (const auto &[name, value] : found[0])
          scale[group_of(name)] = std::max(scale[group_of(name)], std::abs(value));
        for (const auto &[name, value] : found[0])
          EXPECT_NEAR(found[1].at(name), value, 1e-7 * scale[group_of(name)]) << name;
      }
  }

  TEST(SymmetryPlane, KeepsBendingModesAndDropsTorsion)
  {
    auto       p     = elastic_plate(14, 4);
    const auto whole = natural_frequencies(p); // B1 B2 T1 ...
    p.is_halved      = true;
    const auto half  = natural_frequencies(p);
    EXPECT_NEAR(half[0] / whole[0], 1., 1e-6) << "increments of 1e-7 m";
    EXPECT_NEAR(half[1] / whole[1], 1., 1e-6);
    EXPECT_GT(half[2], 1.5 * whole[2]) << "torsion is not symmetric";
  }

  TEST(SymmetryPlane, IsNoFreeEdgeOfTheSurface)
  {
    ThreadPool  pool;
    ShellBlade  half(struck_plate(true), pool);
    const auto  view       = half.facets();
    std::size_t n_symmetry = 0, n_free = 0;
    for (std::size_t f = 0; f < view.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (view.neighbor[f][k] == FacetsView::symmetry_edge)
          {
            ++n_symmetry;
            EXPECT_EQ(view.position[3 * view.nodes[f][k] + 1], 0.);
            EXPECT_EQ(view.position[3 * view.nodes[f][(k + 1) % 4] + 1], 0.);
          }
        else
          n_free += view.neighbor[f][k] == FacetsView::free_edge;
    EXPECT_EQ(n_symmetry, 14u);
    EXPECT_EQ(n_free, 14u + 2u * 3u);
  }

  TEST(SymmetryPlane, AcceptsTheEdgeThatOnlyTheOtherHalfHas)
  {
    ThreadPool pool;
    auto       p       = struck_plate(true);
    p.supports.clamped = "0, 2, 3";
    const ShellBlade half(p, pool);
    // root 4 and trailing edge 15 nodes clamped, one of them in common; 14 more on the plane with three each
    EXPECT_EQ(half.census().n_held_dofs, 6u * 18u + 3u * 14u);
    p.supports.clamped = "0, 5";
    EXPECT_THROW(ShellBlade(p, pool), InputError);
  }

  TEST(SymmetryPlane, RefusesWhatHasNoHalf)
  {
    BladeParameters::Mesh mesh;
    mesh.n_chord = 7;
    EXPECT_THROW(ShellMesh({mesh, {}, true}), InputError);
    mesh.n_chord       = 8;
    mesh.chord_grading = 2.;
    EXPECT_THROW(ShellMesh({mesh, {}, true}), InputError);

    // a plate of which a file has more than the half, the half, less than it
    for (const auto &[lowest, is_fine] : {std::pair(-0.1, false), std::pair(0., true), std::pair(0.1, false)})
      {
        const test::TemporaryMesh file({{{0., lowest, 0.}}, {{1., lowest, 0.}}, {{1., 1., 0.}}, {{0., 1., 0.}}},
                                       {{0, 1, 2, 3}});
        if (!is_fine)
          {
            EXPECT_THROW(ShellMesh({file.parameters(), {}, true}), InputError);
            continue;
          }
        const ShellMesh square({file.parameters(), {}, true});
        ASSERT_EQ(square.symmetry_nodes.size(), 2u);
        for (const auto n : square.symmetry_nodes)
          EXPECT_EQ(square.nodes[n][1], 0.);
        EXPECT_EQ(std::count(square.neighbors[0].begin(), square.neighbors[0].end(), FacetsView::symmetry_edge), 1);
        EXPECT_EQ(std::count(square.neighbors[0].begin(), square.neighbors[0].end(), FacetsView::free_edge), 3);
      }
  }

  TEST(SymmetryPlane, HalvesARigidPlate)
  {
    BladeParameters p;
    p.kind         = BladeKind::rigid;
    p.is_halved    = true;
    p.rigid.motion = RigidMotion::free_along_normal;
    p.rigid.mass   = 3.;
    for (const std::array<double, 3> &normal : {std::array<double, 3>{{0., 0., 1.}}, {{1., 0., 0.}}, {{0.6, 0., 0.8}}})
      {
        p.rigid.normal = normal;
        RigidPlate half(p);
        EXPECT_NEAR(half.census().area, 0.4 * 0.4, 1e-15);
        EXPECT_EQ(half.mass(), 3.);
        EXPECT_EQ(half.n_nodes(), 6u) << "two of its four lie on the plane";
        const auto view = half.facets();
        int        n    = 0;
        for (unsigned int k = 0; k < 4; ++k)
          {
            EXPECT_GE(view.position[3 * k + 1], 0.);
            n += view.neighbor[0][k] == FacetsView::symmetry_edge;
          }
        EXPECT_EQ(n, 1);
      }
  }
} // namespace birdstrike::symmetry_plane_test
