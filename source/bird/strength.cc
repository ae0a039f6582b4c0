#include "bird/strength.h"
#include <birdstrike/bird/bird.h>

/// What strength adds to a step of the bird.
namespace birdstrike
{
  namespace
  {
    /// Particles per thread range: whole registers and whole cache lines of every column.
    constexpr std::size_t grain = 64;
  } // namespace

  void Bird::kick_stress(const double dt)
  {
    const Strength strength(parameters);
    const double   volume = particles.mass / parameters.density; // undeformed
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        const auto step = advance(strength, particles, particles.velocity_gradient, particles.spin, p,
                                  load<Number>(&particles.mu[p]), dt);
        for (int k = 0; k < 6; ++k)
          store(step.stress[k], &particles.stress[k][p]);
        store(load<Number>(&particles.dissipated[p]) + volume * step.dissipated, &particles.dissipated[p]);
      });
    });
  }

  // Nothing but flow damps shear. Predicted by the latest rates alone, as pressure is, its oscillations grow, by 2.4e-3
  // of their amplitude a step at w dt = 0.3; extrapolated in time they lose 1.1e-3, and grow from w dt = 0.65 on.
  void Bird::predict_velocity_gradients()
  {
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        const auto extrapolate = [p](const Particles::Column &latest, Particles::Column &earlier,
                                     Particles::Column &predicting) {
          const Number now = load<Number>(&latest[p]);
          store(2. * now - load<Number>(&earlier[p]), &predicting[p]);
          store(now, &earlier[p]);
        };
        for (int k = 0; k < 6; ++k)
          extrapolate(particles.velocity_gradient[k], particles.earlier_velocity_gradient[k],
                      particles.predicting_velocity_gradient[k]);
        for (int d = 0; d < 3; ++d)
          extrapolate(particles.spin[d], particles.earlier_spin[d], particles.predicting_spin[d]);
      });
    });
  }

  double Bird::shear_energy(const std::size_t p) const
  {
    if (!particles.has_strength)
      return 0.;
    std::array<double, 6> s;
    for (int k = 0; k < 6; ++k)
      s[k] = particles.stress[k][p];
    return contract(s, s) / (4. * parameters.shear_modulus * parameters.density);
  }
} // namespace birdstrike
