#include <birdstrike/bird/bird.h>

/// Evaluation of the rates at what those before foretell, repeated where they foretell badly.
namespace birdstrike
{
  namespace
  {
    /// Energy that the prediction of an evaluation may make, over that with which the bird closes in. The first ten
    /// steps of a shock make two (2.5 mm particles) to forty times as much (8 mm) each, steady flow a hundredth.
    constexpr double largest_prediction_error = 1e-4;
    constexpr double largest_error_of_pores   = 1e-5; ///< which close within a step or two (frontal strike: 0.11 %)

    /// How far the second prediction goes from the old rates to those of the first evaluation. What damps answers a
    /// change of the prediction by -g times it, 0 < g < 1 up to the largest Courant number; 1/(1 + g) is right.
    constexpr double relaxation = 2. / 3.;

    /// Particles per thread range: whole registers and whole cache lines of every column.
    constexpr std::size_t grain = 64;
  } // namespace

  void Bird::compute_rates()
  {
    std::swap(particles.force, particles.predicting_force);
    std::swap(particles.compression_rate, particles.predicting_compression_rate);
    if (particles.has_strength)
      predict_velocity_gradients();
    rates->update(particles, half_step, list, pool);
    if (!is_badly_predicted())
      return;
    relax_prediction();
    rates->update(particles, half_step, list, pool);
    ++n_second;
  }

  bool Bird::is_badly_predicted() const
  {
    const double *const error = particles.prediction_error.data();
    const double        total = pool.ordered_sum(
             particles.size(),
             [&](const std::size_t begin, const std::size_t end) {
        Lanes  whole = 0.;
        double rest  = 0.;
        sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
          if constexpr (std::is_same_v<Number, Lanes>)
            whole += load<Lanes>(error + p);
          else
            rest += error[p];
        });
        return rest + stdx::reduce(whole);
      },
             8192);
    return closing_energy > 0. &&
           total > (is_soft ? largest_error_of_pores : largest_prediction_error) * closing_energy;
  }

  void Bird::relax_prediction()
  {
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        const auto relax = [p](Particles::Column &predicting, const Particles::Column &found) {
          const Number before = load<Number>(&predicting[p]);
          store(before + relaxation * (load<Number>(&found[p]) - before), &predicting[p]);
        };
        for (int d = 0; d < 3; ++d)
          relax(particles.predicting_force[d], particles.force[d]);
        relax(particles.predicting_compression_rate, particles.compression_rate);
        if (!particles.has_strength)
          return;
        for (int k = 0; k < 6; ++k)
          relax(particles.predicting_velocity_gradient[k], particles.velocity_gradient[k]);
        for (int d = 0; d < 3; ++d)
          relax(particles.predicting_spin[d], particles.spin[d]);
      });
    });
  }
} // namespace birdstrike
