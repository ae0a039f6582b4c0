#include "blade_case.h"

#include "structure/deformable_blade.h"

#include <cstring>

namespace birdstrike::test
{
  BladeParameters elastic_plate(const unsigned int n_span, const unsigned int n_chord)
  {
    BladeParameters p;
    p.mesh.n_span        = n_span;
    p.mesh.n_chord       = n_chord;
    p.material.density   = std::to_string(4430.);
    p.material.young     = std::to_string(113.8e9);
    p.material.poisson   = std::to_string(0.342);
    p.material.hardening = "elastic";
    return p;
  }

  BladeParameters free_plate(const unsigned int n_span, const unsigned int n_chord)
  {
    BladeParameters p  = elastic_plate(n_span, n_chord);
    p.supports.clamped = "";
    return p;
  }

  void advance(Blade &blade, const double dt, const unsigned int n_steps)
  {
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        blade.kick_internal(0.5 * dt, HalfKick::first);
        blade.drift(dt);
        blade.compute_internal_forces();
        blade.kick_internal(0.5 * dt, HalfKick::second);
      }
  }

  template <class AnyBlade>
  std::vector<double> shake(BladeParameters p, const unsigned int n_threads)
  {
    p.loads.initial_velocity = "0; 0; 50*(x/0.3112)^2 + 30*x*y";
    p.loads.pressure         = "1e5*x";
    p.loads.damping          = 10.;
    ThreadPool pool(n_threads);
    AnyBlade   blade(p, pool);
    advance(blade, 0.8 * blade.step_limit().value, 30);
    const auto           nodes  = blade.nodes();
    const EnergyReport   energy = blade.energies();
    const MomentumReport m      = blade.momenta();
    std::vector<double>  result(nodes.velocity, nodes.velocity + nodes.n_unknowns * nodes.n);
    result.insert(result.end(), {energy.kinetic, energy.elastic, energy.hourglass, energy.viscous, energy.external_work,
                                 energy.damped});
    result.insert(result.end(), m.angular_momentum.begin(), m.angular_momentum.end());
    return result;
  }

  template std::vector<double> shake<ShellBlade>(BladeParameters, unsigned int);
  template std::vector<double> shake<SolidBlade>(BladeParameters, unsigned int);

  bool is_bitwise_equal(const std::vector<double> &a, const std::vector<double> &b)
  {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }

  double balance(const Blade &blade)
  {
    const EnergyReport energy = blade.energies();
    return energy.total() - energy.external_work - energy.contact_work;
  }
} // namespace birdstrike::test
