#include "../../benchmarks/counted_number.h"
#include "quadratic_brick.h"
#include "study.h"

#include "structure/elements/solid/law.h"
#include <birdstrike/core/errors.h>

namespace birdstrike::studies
{
  namespace
  {
    using benchmarks::Counted;

    /// A cube of 4 mm that is stretched step by step: to 2 % of strain, or within elasticity.
    template <auto &in_plane, auto &across>
    double count(const bool is_plastic)
    {
      using Brick = QuadraticBrick<Counted, in_plane, across>;
      SolidSection section;
      section.material.hardening.law     = HardeningLaw::linear;
      section.material.hardening.modulus = 1.25e9;
      const SolidLaw        law(section);
      SolidPoint<Counted>   point[Brick::n_points];
      typename Brick::Nodes x, u, force;
      for (auto &p : point)
        {
          for (auto &s : p.stress)
            s = 0.;
          p.plastic_strain = p.plastic_work = 0.;
          p.yield                           = law.initial_yield();
        }
      const double strain = is_plastic ? 1e-3 : 1e-6;
      for (int n = 0; n < 27; ++n)
        {
          x[n]     = {2e-3 * (n % 3), 2e-3 * (n / 3 % 3), 2e-3 * (n / 9)};
          u[n]     = {strain * 2e-3 * (n % 3), 0., 0.};
          force[n] = Vector3<Counted>::Constant(Counted(0.));
        }
      Vector3<Counted> q[3];
      for (auto &v : q)
        v = Vector3<Counted>::Constant(Counted(0.));
      const auto step = [&] {
        Counted plastic = 0.;
        Brick::add_forces(
          x, u,
          [&](const Matrix3<Counted> &gradient, const int p, const Counted &volume) {
            plastic += volume * law.update_point(gradient, 1e-7, point[p]);
            return point[p].stress;
          },
          force);
        if constexpr (in_plane.n == 2)
          Brick::add_stabilisation(u, Counted(1.), q, force);
      };
      for (int k = 0; k < 20; ++k)
        step();
      return benchmarks::count_flops(step) + 27. * 3.; // and the sum at the nodes
    }
  } // namespace

  double count_quadratic_flops(const std::string &rule, const bool is_plastic)
  {
    if (rule == "g2")
      return count<gauss_2, gauss_2>(is_plastic);
    if (rule == "g3")
      return count<gauss_3, gauss_3>(is_plastic);
    if (rule == "gl3")
      return count<lobatto_3, lobatto_3>(is_plastic);
    if (rule == "g2xg3")
      return count<gauss_2, gauss_3>(is_plastic);
    if (rule == "g2xg5")
      return count<gauss_2, gauss_5>(is_plastic);
    throw InputError("Flops are counted of quadratic bricks only (those of the others: tests/benchmarks).");
  }
} // namespace birdstrike::studies
