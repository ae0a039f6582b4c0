#include "blade_case.h"
#include "solid_frequencies.h"

#include <birdstrike/blade/make_blade.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cstring>
#include <map>

namespace birdstrike
{
  namespace
  {
    using test::advance;
    using test::balance;

    double norm(const std::array<double, 3> &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    /// The plate of benchmark A4 in bricks, scaled as far as the plane allows.
    BladeParameters scaled_plate(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
    {
      BladeParameters p            = test::elastic_plate(n_span, n_chord);
      p.kind                       = "solid";
      p.mesh.n_layers              = n_layers;
      p.mass_scaling.method        = "selective";
      p.mass_scaling.largest_added = 10.;
      return p;
    }

    BladeParameters without_viscosity(BladeParameters p)
    {
      p.element.linear_viscosity = p.element.quadratic_viscosity = 0.;
      return p;
    }

    TEST(MassScaling, TakesTheStepOfThePlaneForAnyNumberOfLayers)
    {
      ThreadPool pool;
      double     of_one = 0.;
      for (const unsigned int n_layers : {1u, 2u, 4u, 8u})
        {
          auto             p = scaled_plate(14, 4, n_layers);
          const SolidBlade blade(p, pool);
          const auto       scaling = blade.census().mass_scaling;
          EXPECT_NEAR(blade.largest_stable_step() / scaling.step, 1., 1e-12);
          EXPECT_EQ(scaling.n_scaled, blade.n_elements());
          p.mass_scaling.method = "off";
          const SolidBlade plain(p, pool);
          EXPECT_NEAR(scaling.step_before / plain.largest_stable_step(), 1., 1e-12);
          EXPECT_EQ(plain.census().mass_scaling.step, 0.);
          EXPECT_EQ(blade.mass(), plain.mass());
          of_one = n_layers == 1 ? scaling.step : of_one;
          EXPECT_NEAR(scaling.step / of_one, 1., 1e-6);
          EXPECT_GT(scaling.step / plain.largest_stable_step(), 3. * n_layers);
        }
    }

    // A plate of width b with added r^2 per mass: 12 r^2/b^2; r^2 = (factor - 1) h^2/4 in layers of height h.
    TEST(MassScaling, ReportsWhatItAdds)
    {
      ThreadPool pool;
      for (const unsigned int n_layers : {1u, 3u})
        {
          const SolidBlade blade(scaled_plate(28, 8, n_layers), pool);
          const auto       scaling = blade.census().mass_scaling;
          const double     height = 0.00427 / n_layers, b = 0.0889 * std::sqrt(1. + 2. / 64.); // nodes, not bricks
          const double     expected = 3. * (scaling.largest_factor - 1.) * height * height / (b * b);
          EXPECT_NEAR(scaling.added_rotary_inertia / expected, 1., 0.01); // thickness in the plate's own inertia
        }
    }

    TEST(MassScaling, KeepsToItsLimits)
    {
      ThreadPool pool;
      auto       p                 = scaled_plate(14, 4, 4);
      const auto most              = SolidBlade(p, pool).census().mass_scaling;
      p.mass_scaling.largest_added = 0.5 * most.added_rotary_inertia;
      const auto half              = SolidBlade(p, pool).census().mass_scaling;
      EXPECT_LE(half.added_rotary_inertia, p.mass_scaling.largest_added);
      EXPECT_GT(half.added_rotary_inertia, 0.98 * p.mass_scaling.largest_added);
      EXPECT_LT(half.step, most.step);
      p.mass_scaling.target_step = 0.5 * (half.step + half.step_before);
      const SolidBlade wanted(p, pool);
      EXPECT_NEAR(wanted.largest_stable_step() / p.mass_scaling.target_step, 1., 1e-6);
      p.mass_scaling.target_step = 0.5 * half.step_before; // allowed as it is
      EXPECT_EQ(SolidBlade(p, pool).census().mass_scaling.n_scaled, 0u);

      const auto expect_refused = [&](const double step, const std::string &why) {
        p.mass_scaling.target_step = step;
        try
          {
            SolidBlade blade(p, pool);
            ADD_FAILURE() << step;
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find("Mass scaling/Target step"), std::string::npos);
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
          }
      };
      expect_refused(most.step, "Largest added inertia");
      expect_refused(2. * most.step, "dimensions in the plane");
    }

    TEST(MassScaling, FreePlateKeepsItsMomenta)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(8, 4, 3);
      p.supports.clamped       = "";
      p.loads.initial_velocity = "3 + 20*sin(30*y); 2 - 8*cos(20*x); 10*sin(12*x+20*y) + 5 + 1000*z";
      p.loads.initial_spin     = "200; -300; 100";
      SolidBlade   blade(p, pool);
      const auto   before = blade.momenta();
      const double energy = balance(blade), dt = 0.8 * blade.step_limit().value;
      advance(blade, dt, 1000);
      const auto after = blade.momenta();
      for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * norm(before.momentum));
          EXPECT_NEAR(after.angular_momentum[d], before.angular_momentum[d], 1e-11 * norm(before.angular_momentum));
        }
      EXPECT_NEAR(balance(blade) / energy, 1., 2e-3);
    }

    // Ten turns of a stressed block of thin layers, whose spin winds and unwinds them: the step is four times that of
    // the layers.
    TEST(MassScaling, SpinningBlockKeepsItsEnergy)
    {
      ThreadPool pool;
      auto       p       = without_viscosity(scaled_plate(3, 3, 4));
      p.supports.clamped = p.supports.tip = "";
      p.mesh.length = p.mesh.chord = 0.03;
      p.thickness.value            = "0.01";
      p.loads.initial_velocity     = "3000*x; -1500*y; 4000*z";
      p.loads.initial_spin         = "2000; 1000; 30000";
      SolidBlade   blade(p, pool);
      const double initial = balance(blade), dt = 0.8 * blade.largest_stable_step();
      const auto   momentum = blade.momenta().angular_momentum;
      EXPECT_GT(dt, 2. * blade.census().mass_scaling.step_before);
      const double turn  = 2. * M_PI / 30000.;
      double       worst = 0.;
      for (unsigned int k = 0; k < 100; ++k)
        {
          advance(blade, dt, static_cast<unsigned int>(0.1 * turn / dt) + 1);
          worst = std::max(worst, std::abs(balance(blade) / initial - 1.));
        }
      RecordProperty("worst", std::to_string(worst));
      EXPECT_LT(worst, 1e-3);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(blade.momenta().angular_momentum[d], momentum[d], 1e-10 * norm(momentum));
    }

    // Held columns, single held components within columns, loads that act on their nodes: what is not in the blade is
    // in its supports.
    TEST(MassScaling, SupportsTakeTheImpulse)
    {
      ThreadPool pool;
      auto       p          = scaled_plate(8, 4, 3);
      p.loads.pressure      = "1e5*sin(2e3*t)";
      p.loads.point_loads   = "0.3112 0 0: 0; 10; 100 | 0.3112 0.0444 -0.0021: 3; 0; 20";
      p.supports.held_boxes = "0.31 0.044 -0.01 0.32 0.045 -0.001: ux uz; 0.15 -0.045 0 0.16 -0.044 0.001: uy";
      SolidBlade blade(p, pool);
      advance(blade, 0.8 * blade.step_limit().value, 500);
      const auto m = blade.momenta();
      EXPECT_GT(norm(m.external_impulse), 0.05);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(m.momentum[d] + m.support_impulse[d], m.external_impulse[d], 1e-12 * norm(m.external_impulse));
      const auto nodes = blade.nodes();
      for (std::size_t i = 0; i < 3 * nodes.n; ++i)
        if (nodes.inverse_mass[i] == 0.)
          {
            EXPECT_EQ(nodes.velocity[i], 0.);
          }
      EXPECT_NEAR(balance(blade) / blade.energies().external_work, 0., 1e-3);
    }

    TEST(MassScaling, LoadsAndDampingCloseTheBalance)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(14, 4, 2);
      p.loads.pressure         = "3e4*(1 - exp(-2e3*t))";
      p.loads.initial_velocity = "0; 0; 500*z";
      p.loads.damping          = 4000.;
      SolidBlade   blade(p, pool);
      const double initial = balance(blade);
      advance(blade, 0.9 * blade.step_limit().value, 3000);
      const auto energy = blade.energies();
      EXPECT_GT(energy.dissipated, 0.05 * energy.external_work);
      EXPECT_LT(std::abs(balance(blade) - initial), 1e-4 * energy.external_work);
    }

    // Kicks by contact alone, on one face, before and after drifts: the kinetic energy with M_s grows by the work that
    // is booked, the impulse and its moment arrive.
    TEST(MassScaling, ContactKicksAreConsistent)
    {
      ThreadPool pool;
      auto       p       = scaled_plate(6, 3, 3);
      p.supports.clamped = "";
      SolidBlade   blade(p, pool);
      const auto   view    = blade.facets();
      const double h       = 1e-9;
      Point3       impulse = Point3::Zero(), moment = Point3::Zero();
      blade.clear_contact_forces();
      for (std::size_t n = 0; n < view.n_nodes; n += 3)
        {
          const Point3 f(10. * std::sin(double(n)), 5., 100. * std::cos(2. * double(n)));
          for (unsigned int d = 0; d < 3; ++d)
            view.force[3 * n + d] += f[d];
          impulse += 20. * h * f;
          moment += 20. * h * Point3(view.position + 3 * n).cross(f);
        }
      for (unsigned int k = 0; k < 10; ++k)
        {
          blade.kick_contact(h, HalfKick::first);
          blade.kick_contact(h, HalfKick::second);
        }
      blade.kick_contact(0., HalfKick::first); // the report is then at the present velocity
      const auto energy = blade.energies();
      const auto m      = blade.momenta();
      EXPECT_GT(energy.kinetic, 0.);
      EXPECT_NEAR(energy.kinetic / energy.contact_work, 1., 1e-12);
      for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(m.momentum[d], impulse[d], 1e-12 * impulse.norm());
          EXPECT_NEAR(m.contact_impulse[d], impulse[d], 1e-12 * impulse.norm());
          EXPECT_NEAR(m.angular_momentum[d], moment[d], 1e-12 * moment.norm());
        }
    }

    TEST(MassScaling, IsBitwiseEqualForAnyNumberOfThreads)
    {
      std::vector<double> results[2];
      for (const unsigned int n_threads : {1u, 2u})
        {
          ThreadPool pool(n_threads);
          auto       p             = scaled_plate(60, 36, 2);
          p.loads.initial_velocity = "0; 0; 50*(x/0.3112)^2 + 30*x*y";
          p.loads.pressure         = "1e5*x";
          p.loads.damping          = 10.;
          SolidBlade blade(p, pool);
          advance(blade, 0.8 * blade.step_limit().value, 20);
          const auto nodes  = blade.nodes();
          auto      &result = results[n_threads - 1];
          result.assign(nodes.velocity, nodes.velocity + 3 * nodes.n);
          const auto energy  = blade.energies();
          const auto momenta = blade.momenta();
          result.insert(result.end(), {energy.kinetic, energy.elastic, energy.external_work, energy.dissipated,
                                       momenta.angular_momentum[0], momenta.angular_momentum[1]});
        }
      EXPECT_EQ(std::memcmp(results[0].data(), results[1].data(), results[0].size() * sizeof(double)), 0);
    }

    std::map<std::array<double, 3>, std::size_t> nodes_by_place(SolidBlade &blade)
    {
      const auto                                   nodes = blade.nodes();
      std::map<std::array<double, 3>, std::size_t> result;
      const auto                                   round = [](const double x) { return std::round(1e9 * x) + 0.; };
      for (std::size_t n = 0; n < nodes.n; ++n)
        {
          const double *x                                   = nodes.reference + 3 * n;
          result[{{round(x[0]), round(x[1]), round(x[2])}}] = n;
        }
      return result;
    }

    TEST(MassScaling, HalfAPlateMovesLikeTheWhole)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(14, 6, 2);
      p.loads.pressure         = "-2e6*exp(-(x-0.2)^2/0.001-y^2/0.0005)";
      p.loads.initial_velocity = "-20*x; 300*y; -200*(x/0.3)^2*(1-300*y^2)";
      SolidBlade whole(p, pool);
      p.is_halved = true;
      SolidBlade half(p, pool);
      EXPECT_NEAR(half.census().mass_scaling.added_rotary_inertia / whole.census().mass_scaling.added_rotary_inertia,
                  1., 1e-9);
      const double dt = 0.8 * whole.largest_stable_step();
      EXPECT_NEAR(half.largest_stable_step() / whole.largest_stable_step(), 1., 1e-9);
      advance(whole, dt, 500);
      advance(half, dt, 500);
      const auto a = whole.nodes(), b = half.nodes();
      const auto place  = nodes_by_place(whole);
      double     length = 0., largest = 0.;
      for (const auto &[where, n] : nodes_by_place(half))
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double u = a.displacement[3 * place.at(where) + c];
            length         = std::max(length, std::abs(u));
            largest        = std::max(largest, std::abs(u - b.displacement[3 * n + c]));
          }
      EXPECT_GT(length, 0.005);
      EXPECT_LT(largest, 1e-9 * length);
      EXPECT_NEAR(2. * half.energies().total() / whole.energies().total(), 1., 1e-9);
    }

    /// Lowest frequencies (Hz) of a plate of equal bricks with M_s: subspace iteration with K and M_s.
    std::vector<double> scaled_frequencies(SolidBlade &blade, const unsigned int n_modes)
    {
      std::vector<Eigen::Index>         number;
      const Eigen::SparseMatrix<double> matrix   = test::scaled_stiffness(blade, number);
      const auto                        nodes    = blade.nodes();
      const FieldSnapshot               snapshot = blade.snapshot();
      const double                      k =
        blade.mass() / double(blade.n_elements()) / 16. * (blade.census().mass_scaling.largest_factor - 1.);
      std::vector<Eigen::Triplet<double>> entries;
      for (std::size_t i = 0; i < 3 * nodes.n; ++i)
        if (number[i] >= 0)
          entries.emplace_back(number[i], number[i], 1.);
      for (std::size_t cell = 0; cell < snapshot.cells.size(); cell += 8)
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int c = 0; c < 3; ++c)
            {
              const std::size_t ends[2] = {3 * snapshot.cells[cell + v] + c, 3 * snapshot.cells[cell + v + 4] + c};
              for (const std::size_t i : ends)
                for (const std::size_t j : ends)
                  if (number[i] >= 0 && number[j] >= 0)
                    entries.emplace_back(number[i], number[j],
                                         (i == j ? k : -k) / std::sqrt(nodes.mass[i] * nodes.mass[j]));
            }
      Eigen::SparseMatrix<double> mass(matrix.rows(), matrix.rows());
      mass.setFromTriplets(entries.begin(), entries.end());
      const Eigen::SparseMatrix<double> transpose = matrix.transpose(), stiffness = 0.5 * (matrix + transpose);
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
      Eigen::MatrixXd                                          modes(matrix.rows(), n_modes + 6);
      for (Eigen::Index i = 0; i < modes.size(); ++i)
        modes.data()[i] = std::sin(1. + 12.9898 * double(i % 7919) + double(i));
      Eigen::VectorXd values;
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          modes = solver.solve(mass * modes);
          modes = modes.householderQr().householderQ() * Eigen::MatrixXd::Identity(modes.rows(), modes.cols());
          const Eigen::MatrixXd K = modes.transpose() * (stiffness * modes), M = modes.transpose() * (mass * modes);
          const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(K, M);
          modes  = modes * small.eigenvectors();
          values = small.eigenvalues();
        }
      std::vector<double> frequencies;
      for (unsigned int k_mode = 0; k_mode < n_modes; ++k_mode)
        frequencies.push_back(std::sqrt(values[k_mode]) / (2. * M_PI));
      return frequencies;
    }

    // Benchmarks A4 and B8 (Mindlin's theory, as in SolidBlade) with the step of the plane: bending is lowered by
    // (2 pi r/L)^2/2, torsion by half of what the report says.
    TEST(MassScaling, LowersFrequenciesByWhatItSays)
    {
      ThreadPool pool;
      const auto p          = without_viscosity(scaled_plate(28, 8, 2));
      auto       q          = p;
      q.mass_scaling.method = "off";
      SolidBlade   scaled(p, pool), plain(q, pool);
      const auto   f = scaled_frequencies(scaled, 4), g = test::natural_frequencies(plain, 4);
      const double added = scaled.census().mass_scaling.added_rotary_inertia;
      for (unsigned int k = 0; k < 4; ++k)
        {
          RecordProperty("mode_" + std::to_string(k + 1), std::to_string(f[k]));
          EXPECT_LT(f[k], g[k]);
        }
      EXPECT_NEAR(f[0] / 36.863, 1., 0.01);
      EXPECT_NEAR(f[1] / 230.15, 1., 0.01);
      EXPECT_NEAR((1. - f[2] / g[2]) / (0.5 * added), 1., 0.15); // first torsion
      EXPECT_LT(1. - f[0] / g[0], 0.05 * added);
      EXPECT_LT(1. - f[1] / g[1], 0.3 * added);
    }

    TEST(MassScaling, MeansNothingForAShell)
    {
      auto p = scaled_plate(4, 2, 1);
      EXPECT_TRUE(p.unused_entries().empty());
      p.kind = "shell";
      EXPECT_EQ(p.unused_entries(),
                (std::vector<std::string>{"Mass scaling/Method", "Mass scaling/Largest added inertia"}));
    }
  } // namespace
} // namespace birdstrike
