#include "../record.h"
#include "blade_case.h"

#include "structure/deformable_blade.h"

#include <cmath>
#include <map>
#include <vector>

namespace birdstrike::bird_load_test
{
  namespace
  {
    /// The blade plate under the force of a jet on a disc of the bird's diameter at 70 % of the span, which the plate
    /// escapes by its own speed w' there (A the bird's cross-section, eta the share of it that hits):
    ///   F = eta rho A (v sin(theta) - w')^2/sin(theta)  until  int (v - w'/sin(theta)) dt = L
    struct Bird
    {
      double mass, speed, angle, share; ///< kg, m/s, degrees, eta
    };

    struct Response
    {
      double                   impulse = 0., load_end = 0., work = 0., plastic_work = 0., peak = 0.; ///< SI
      std::map<double, double> tip; ///< m, at times (s)
    };

    Response strike(const Bird &bird, const std::vector<double> &times)
    {
      const double density = 950., sine = std::sin(bird.angle * M_PI / 180.);
      const double diameter = std::cbrt(2. * bird.mass / (M_PI * density)), area = 0.25 * M_PI * diameter * diameter;
      auto         p       = test::elastic_plate(28, 8);
      p.material.hardening = "linear";
      p.material.yield     = "880e6";
      p.material.modulus   = "1.25e9";
      p.element.n_points   = 5; // as the peer
      ThreadPool               pool;
      ShellBlade               blade(p, pool);
      const NodeArrays         nodes = blade.nodes();
      std::vector<std::size_t> struck;
      for (std::size_t n = 0; n < nodes.n; ++n)
        if (std::hypot(nodes.reference[3 * n] - 0.21784, nodes.reference[3 * n + 1]) < 0.5 * diameter)
          struck.push_back(n);

      const double dt = 0.9 * blade.step_limit().value;
      Response     result;
      double       consumed = 0., time = 0.;
      auto         next = times.begin();
      while (next != times.end())
        {
          blade.kick_internal(0.5 * dt, HalfKick::first);
          blade.kick_contact(0.5 * dt, HalfKick::first);
          blade.drift(dt);
          blade.compute_internal_forces();
          double speed = 0.;
          for (const std::size_t n : struck)
            speed += nodes.velocity[6 * n + 2] / struck.size();
          const NodeForces contact  = blade.clear_contact_forces();
          const double     approach = bird.speed * sine - speed;
          const bool       acts     = consumed < 2. * diameter && approach > 0.;
          const double     force    = acts ? bird.share * density * area * approach * approach / sine : 0.;
          for (const std::size_t n : struck)
            contact.of(n)[2] += force / struck.size();
          blade.kick_contact(0.5 * dt, HalfKick::second);
          blade.kick_internal(0.5 * dt, HalfKick::second);
          time += dt;
          result.impulse += force * dt;
          consumed += acts ? approach / sine * dt : 0.;
          result.load_end  = acts ? time : result.load_end;
          const double tip = blade.tip_deflection().mid_chord;
          result.peak      = std::max(result.peak, tip);
          if (time >= *next)
            result.tip[*next++] = tip;
        }
      result.work         = blade.energies().contact_work;
      result.plastic_work = blade.energies().plastic;
      EXPECT_LT(std::abs(test::balance(blade)), 2e-3 * result.work);
      return result;
    }
  } // namespace

  // Benchmark E3, a peer code (plain Belytschko-Tsay) on the same mesh. Its 14 x 4 and 28 x 8 elements agree within 2 %
  // in impulse, tip and work, the disc is made of whole nodes here: 3 % for impulse and end, 5 % for the path from 2 ms
  // on (before, the tip has hardly moved), 10 % for plastic work, which the row at the root decides.
  TEST(BirdLoad, ABladeThatGivesWayTakesLess)
  {
    struct Case
    {
      const char *name;
      Bird        bird;
      double      impulse, load_end, work, plastic_work;
      double      tip[3]; ///< at 2, 5, 10 ms
    };
    for (const Case &c :
         {Case{"frontal", {0.1005, 177.4, 90., 1.}, 13.96, 590e-6, 522., 431., {76.8e-3, 225.5e-3, 278e-3}},
          Case{"oblique", {0.0826, 302.1, 36.4, 1.}, 11.56, 324e-6, 449., 373., {63.5e-3, 198.9e-3, 250e-3}},
          Case{"half the bird", {0.0826, 302.1, 36.4, .5}, 6.56, 284e-6, 139., 96., {41.0e-3, 113.4e-3, 137e-3}}})
      {
        SCOPED_TRACE(c.name);
        const Response    found = strike(c.bird, {2e-3, 5e-3, 10e-3});
        const std::string name  = c.name;
        record(name + " impulse", found.impulse);
        record(name + " end", found.load_end);
        record(name + " work", found.work);
        record(name + " plastic work", found.plastic_work);
        EXPECT_NEAR(found.impulse / c.impulse, 1., 0.03);
        EXPECT_NEAR(found.load_end / c.load_end, 1., 0.03);
        EXPECT_NEAR(found.work / c.work, 1., 0.10);
        EXPECT_NEAR(found.plastic_work / c.plastic_work, 1., 0.10);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const double time = k == 0 ? 2e-3 : k == 1 ? 5e-3 : 10e-3;
            record(name + " tip " + std::to_string(int(1e3 * time + 0.5)) + " ms", found.tip.at(time));
            EXPECT_NEAR(found.tip.at(time) / c.tip[k], 1., 0.05) << time;
          }
      }
  }
} // namespace birdstrike::bird_load_test
