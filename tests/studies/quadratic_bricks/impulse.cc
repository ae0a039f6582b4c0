#include "study.h"

#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace birdstrike::studies
{
  namespace
  {
    double thread_time()
    {
      timespec t;
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
      return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    }

    /// Lagrange polynomials of degree 1 or 2 at xi in [-1, 1].
    std::array<double, 3> shape(const unsigned int degree, const double xi)
    {
      if (degree == 1)
        return {0.5 * (1. - xi), 0.5 * (1. + xi), 0.};
      return {0.5 * xi * (xi - 1.), 1. - xi * xi, 0.5 * xi * (xi + 1.)};
    }

    /// Consistent shares of the nodes in a uniform pressure on the disc, half on each face; their sum is one.
    std::vector<double> distribute(const Part &part, const Plate &plate, const Pulse &pulse)
    {
      constexpr int       n_samples = 400; ///< across the diameter
      const unsigned int  p         = part.degree;
      const double        edge[2]   = {plate.length / plate.n[0], plate.chord / plate.n[1]};
      std::vector<double> on_grid(std::size_t(part.n_grid[0]) * part.n_grid[1], 0.), share(part.nodes.size(), 0.);
      double              total = 0.;
      for (int a = 0; a < n_samples; ++a)
        for (int b = 0; b < n_samples; ++b)
          {
            const double s = pulse.diameter * ((a + 0.5) / n_samples - 0.5),
                         t = pulse.diameter * ((b + 0.5) / n_samples - 0.5);
            if (s * s + t * t > 0.25 * pulse.diameter * pulse.diameter)
              continue;
            const double place[2] = {(pulse.station * plate.length + s) / edge[0], (0.5 * plate.chord + t) / edge[1]};
            const auto   i = static_cast<unsigned int>(place[0]), j = static_cast<unsigned int>(place[1]);
            const auto   N = shape(p, 2. * (place[0] - i) - 1.), M = shape(p, 2. * (place[1] - j) - 1.);
            for (unsigned int l = 0; l <= p; ++l)
              for (unsigned int k = 0; k <= p; ++k)
                on_grid[p * i + k + part.n_grid[0] * std::size_t(p * j + l)] += N[k] * M[l];
            total += 1.;
          }
      const bool is_shell = part.n_grid[2] == 1;
      for (std::size_t n = 0; n < share.size(); ++n)
        if (const auto &g = part.grid[n]; g[2] == 0 || g[2] == part.n_grid[2] - 1)
          share[n] = (is_shell ? 1. : 0.5) / total * on_grid[g[0] + part.n_grid[0] * std::size_t(g[1])];
      return share;
    }

    /// Mid-chord of the tip, on both faces.
    std::vector<std::size_t> find_tip(const Part &part)
    {
      std::vector<std::size_t> tip;
      for (std::size_t n = 0; n < part.nodes.size(); ++n)
        if (const auto &g = part.grid[n];
            g[0] == part.n_grid[0] - 1 && 2 * g[1] == part.n_grid[1] - 1 && (g[2] == 0 || g[2] == part.n_grid[2] - 1))
          tip.push_back(n);
      if (tip.empty())
        throw InputError(
          "The tip's deflection is that of mid-chord: an even number of linear elements is needed there.");
      return tip;
    }

    /// Central differences, velocities at half steps.
    class Motion
    {
    public:
      Motion(Part &part, std::vector<double> share)
        : part(part)
        , share(std::move(share))
        , velocity(part.mass.size(), 0.)
        , force(velocity)
        , increment(velocity)
        , old_force(velocity)
      {
        for (const Point3 &x : part.nodes)
          position.insert(position.end(), {x[0], x[1], x[2]});
      }

      /// With the load (N) at the present time.
      void step(const double dt, const double load)
      {
        const unsigned int n_u     = part.n_unknowns;
        const double       average = 0.5 * (dt + last_dt);
        kinetic                    = 0.;
        for (std::size_t n = 0; n < part.nodes.size(); ++n)
          for (unsigned int c = 0; c < n_u; ++c)
            {
              const std::size_t i      = n_u * n + c;
              const double      outer  = c == 2 ? load * share[n] : 0.;
              const double      before = velocity[i];
              velocity[i]         = part.grid[n][0] == 0 ? 0. : before + average * (force[i] + outer) / part.mass[i];
              const double middle = before + (velocity[i] - before) * 0.5 * last_dt / average;
              kinetic += 0.5 * part.mass[i] * middle * middle;
              external += outer * 0.5 * (increment[i] + velocity[i] * dt); // trapezoidal, as the inner work
              increment[i] = velocity[i] * dt;
              if (c < 3)
                position[3 * n + c] += increment[i];
            }
        last_dt         = dt;
        balance         = kinetic + inner - external_before;
        external_before = external;
        old_force.swap(force);
        const double start = thread_time();
        part.compute_internal_forces(position.data(), increment.data(), dt, force.data());
        times.push_back(thread_time() - start);
        for (std::size_t i = 0; i < force.size(); ++i)
          inner -= 0.5 * (old_force[i] + force[i]) * increment[i];
      }

      Part               &part;
      std::vector<double> share, position, velocity, force, increment, old_force;
      double              last_dt = 0., kinetic = 0., inner = 0., external = 0., external_before = 0., balance = 0.;
      std::vector<double> times; ///< s, of the forces of each step
    };
  } // namespace

  ImpulseResult run_impulse(Part &part, const Plate &plate, const Pulse &pulse, const double end_time)
  {
    Motion                         motion(part, distribute(part, plate, pulse));
    const std::vector<std::size_t> tip = find_tip(part);
    std::vector<double>            mode;
    ImpulseResult                  result{};
    double                         time = 0., exact = 0.;
    while (time < end_time)
      {
        if (part.stable_step_bound() == 0. && result.n_steps % 200 == 0)
          exact = compute_stable_step(*part.make_elastic(motion.position.data()), motion.position.data(),
                                      mode.empty() ? 100 : 20, mode);
        const double limit = part.stable_step_bound() > 0. ? part.stable_step_bound() : exact;
        const double dt    = std::min(0.9 * limit, end_time - time + 1e-15);
        // the velocity's step spans half a step to either side: what it sees of the pulse adds up to all of it
        const double begin = time - 0.5 * motion.last_dt, end = time + 0.5 * dt;
        const double part_of_step = std::max(0., std::min(end, pulse.duration) - begin) / (end - begin);
        motion.step(dt, part_of_step * pulse.impulse / pulse.duration);
        time += dt;
        ++result.n_steps;
        result.tip = 0.;
        for (const std::size_t n : tip)
          result.tip += (motion.position[3 * n + 2] - part.nodes[n][2]) / double(tip.size());
        if (result.tip > result.peak)
          {
            result.peak      = result.tip;
            result.peak_time = time;
          }
        result.energy_error = std::max(result.energy_error, std::abs(motion.balance));
      }
    result.energy_error /= motion.external;
    result.plastic_work     = part.plastic_work();
    result.hourglass_energy = part.hourglass_energy();
    const auto median       = motion.times.begin() + std::ptrdiff_t(motion.times.size() / 2);
    std::nth_element(motion.times.begin(), median, motion.times.end());
    result.seconds = *median * double(result.n_steps);
    return result;
  }

  double measure_cost(Part &part, const bool is_plastic)
  {
    const double        strain = is_plastic ? 1e-3 : 1e-6, length = part.nodes.back()[0];
    std::vector<double> position, increment(part.mass.size(), 0.), force(increment);
    for (std::size_t n = 0; n < part.nodes.size(); ++n)
      {
        const Point3 &x = part.nodes[n];
        position.insert(position.end(), {x[0], x[1], x[2]});
        double *u = &increment[part.n_unknowns * n];
        u[0]      = strain * x[0] * (1. + x[2] / length);
      }
    const auto move = [&] {
      for (std::size_t n = 0; n < part.nodes.size(); ++n)
        for (unsigned int c = 0; c < 3; ++c)
          position[3 * n + c] += increment[part.n_unknowns * n + c];
      part.compute_internal_forces(position.data(), increment.data(), 1e-7, force.data());
    };
    for (int k = 0; k < 20; ++k) // to 2 % of strain, or to and fro
      {
        move();
        if (!is_plastic)
          for (double &u : increment)
            u = -u;
      }
    if (is_plastic)
      for (double &u : increment)
        u *= 0.02;
    double least = 1e300;
    for (int repetition = 0; repetition < 400; ++repetition)
      {
        const double start = thread_time();
        move();
        least = std::min(least, thread_time() - start);
        if (!is_plastic)
          for (double &u : increment)
            u = -u;
      }
    return 1e9 * least / double(part.n_elements);
  }
} // namespace birdstrike::studies
