#include "oriented_strike.h"

#include <birdstrike/structure/make_blade.h>
#include <birdstrike/structure/probes/mid_chord.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace birdstrike::test
{
  std::vector<unsigned int> quadrilateral(const bool is_reversed, const unsigned int first)
  {
    std::vector<unsigned int> order;
    for (unsigned int k = 0; k < 4; ++k)
      order.push_back((is_reversed ? 8 - k - first : k + first) % 4);
    return order;
  }

  Listing always(const std::vector<unsigned int> &order)
  {
    return {[order] { return order; }};
  }

  Listing mixed(const std::vector<std::vector<unsigned int>> &orders, const unsigned int seed)
  {
    return {[orders, random = std::make_shared<std::mt19937>(seed)] { return orders[(*random)() % orders.size()]; },
            seed};
  }

  Listing mixed_shell(const unsigned int seed)
  {
    std::vector<std::vector<unsigned int>> orders;
    for (const bool is_reversed : {false, true})
      for (const unsigned int first : {0u, 1u, 2u, 3u})
        orders.push_back(quadrilateral(is_reversed, first));
    return mixed(orders, seed);
  }

  std::vector<double> Reports::figures() const
  {
    std::vector<double> all{tip.mid_chord,     tip.leading,         tip.trailing,
                            root.normal_force, root.bending_moment, root.transverse_force};
    for (const auto *list : {&root.chord_position, &root.stress_struck, &root.stress_rear, &line})
      all.insert(all.end(), list->begin(), list->end());
    return all;
  }

  void Reports::swap_edges()
  {
    std::swap(tip.leading, tip.trailing);
    for (double &position : root.chord_position)
      position = -position;
    for (auto *list : {&root.chord_position, &root.stress_struck, &root.stress_rear})
      std::reverse(list->begin(), list->end());
  }

  Reports strike(BladeParameters p, const int side, const Matrix3<double> &turned)
  {
    const Point3 bird = turned * Point3(0., 100., side * 150.), target = turned * Point3(0.2, 0., 0.);
    p.bird = {{{target[0], target[1], target[2]}}, {{bird[0], bird[1], bird[2]}}};
    std::ostringstream speed;
    speed.precision(17);
    for (int d = 0; d < 3; ++d)
      speed << (d > 0 ? "; " : "") << side * turned(d, 2) << "*(10*(x_/0.3112)^2 + 40*x_*y_)";
    p.loads.initial_velocity = speed.str();
    for (const auto &[name, axis] : {std::pair{"x_", 0}, {"y_", 1}}) // along the axes of the plate
      {
        std::ostringstream along;
        along.precision(17);
        along << '(' << turned(0, axis) << "*x+" << turned(1, axis) << "*y+" << turned(2, axis) << "*z)";
        for (std::size_t at; (at = p.loads.initial_velocity.find(name)) != std::string::npos;)
          p.loads.initial_velocity.replace(at, 2, along.str());
      }
    ThreadPool   pool(1);
    const auto   blade = make_blade(p, pool);
    MidChord     line(blade->facets(), *blade->span_line());
    const double step = 2e-6;
    EXPECT_LT(step, blade->step_limit().value * (p.kind == BladeKind::shell ? 1. : 10.));
    const auto        n = static_cast<unsigned int>(std::ceil(step / (0.8 * blade->step_limit().value)));
    RootSectionReport mean{};
    for (unsigned int k = 0; k < 150; ++k)
      {
        advance(*blade, step / n, n);
        const RootSectionReport now = blade->root_section();
        mean.normal_force += now.normal_force / 150.;
        mean.bending_moment += now.bending_moment / 150.;
        mean.transverse_force += now.transverse_force / 150.;
      }
    Reports reports{blade->tip_deflection(), blade->root_section(), {}};
    reports.root.normal_force     = mean.normal_force;
    reports.root.bending_moment   = mean.bending_moment;
    reports.root.transverse_force = mean.transverse_force;
    line.compute_deflection(reports.line);
    return reports;
  }

  void expect_same(const Reports &a, const Reports &b, const double tolerance, const std::string &what)
  {
    const auto x = a.figures(), y = b.figures();
    ASSERT_EQ(x.size(), y.size()) << what;
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        const double scale = k < 3                  ? std::abs(a.tip.mid_chord)
                             : k == 4               ? std::abs(a.root.bending_moment)
                             : k < 6                ? std::abs(a.root.transverse_force)
                             : std::abs(x[k]) > 1e3 ? a.root.peak_stress()
                                                    : 1e-2;
        EXPECT_NEAR(x[k], y[k], tolerance * scale) << what << ", figure " << k;
      }
  }
} // namespace birdstrike::test
