#include "measure.h"

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/material/equation_of_state.h>
#include <birdstrike/material/metal.h>
#include <birdstrike/material/radial_return.h>

namespace birdstrike::benchmarks
{
  namespace
  {
    constexpr std::size_t n_points = 4096; // 32 KiB an array: in the second cache

    void add_one(const std::string &name, const std::string &unit, const std::function<void()> &body)
    {
      add("material/" + name, {{n_points, 1, 7}}, [=](benchmark::State &state, const Setting &, const std::string &) {
        run_loop(state, body);
        count_work(state, n_points, unit);
      });
    }

    Hardening make_hardening(const HardeningLaw law)
    {
      Hardening hardening;
      hardening.law      = law;
      hardening.modulus  = law == HardeningLaw::johnson_cook ? 331e6 : 1.25e9;
      hardening.exponent = law == HardeningLaw::johnson_cook ? 0.34 : 1.;
      if (law == HardeningLaw::johnson_cook)
        hardening.rate_factor = 0.012;
      return hardening;
    }

    /// Trial stresses up to 1.2 times the yield stress (plastic: all beyond it; elastic: none), all lanes different.
    double trial_scale(const std::size_t p, const bool is_plastic)
    {
      const double vary = static_cast<double>(p % 61) / 61.;
      return is_plastic ? 1.02 + 0.18 * vary : 0.1 + 0.8 * vary;
    }

    void add_plane_stress(const std::string &name, const HardeningLaw law, const bool is_plastic)
    {
      const Hardening       hardening = make_hardening(law);
      AlignedVector<double> stress[3], sink(n_points);
      for (auto &component : stress)
        component.resize(n_points);
      for (std::size_t p = 0; p < n_points; ++p)
        {
          const double s = trial_scale(p, is_plastic) * hardening.yield / std::sqrt(1. - 0.3 + 0.09 + 3. * 0.04);
          stress[0][p]   = s;
          stress[1][p]   = 0.3 * s;
          stress[2][p]   = 0.2 * s;
        }
      add_one("plane_stress_return/" + name, "point", [=]() mutable {
        for (std::size_t p = 0; p < n_points; p += n_lanes)
          {
            Lanes      s[3] = {load<Lanes>(&stress[0][p]), load<Lanes>(&stress[1][p]), load<Lanes>(&stress[2][p])};
            const auto d    = plane_stress_return(Elasticity(), hardening, Lanes(0.01),
                                                  Lanes(hardening.yield + 1e-9 * s[0]), Lanes(1.), 1e-6, s);
            store(s[0] + s[1] + s[2] + d.strain, &sink[p]);
          }
        benchmark::DoNotOptimize(sink.data());
        benchmark::ClobberMemory();
      });
    }

    void add_radial(const std::string &name, const HardeningLaw law, const bool is_plastic)
    {
      const Hardening       hardening = make_hardening(law);
      AlignedVector<double> stress(n_points), sink(n_points);
      for (std::size_t p = 0; p < n_points; ++p)
        stress[p] = trial_scale(p, is_plastic) * hardening.yield;
      add_one("radial_return/" + name, "point", [=]() mutable {
        for (std::size_t p = 0; p < n_points; p += n_lanes)
          {
            Lanes s[6];
            s[0] = load<Lanes>(&stress[p]);
            s[3] = 0.01 * s[0];
            s[1] = s[2] = s[4] = s[5] = 0.;
            const auto d = radial_return(Elasticity(), hardening, Lanes(0.01), Lanes(hardening.yield + 1e-9 * s[0]),
                                         Lanes(1.), 1e-6, s);
            store(s[0] + s[1] + s[2] + s[3] + d.strain, &sink[p]);
          }
        benchmark::DoNotOptimize(sink.data());
        benchmark::ClobberMemory();
      });
    }

    void add_equation_of_state(const std::string &type)
    {
      EosParameters parameters;
      parameters.type           = eos_types().at(type);
      parameters.pressure_table = "0: 0; 0.02: 22e6; 0.05: 61e6; 0.1: 146e6; 0.2: 421e6; 0.3: 911e6";
      const EquationOfState eos(parameters, 950.);
      AlignedVector<double> mu(n_points), sink(n_points);
      for (std::size_t p = 0; p < n_points; ++p)
        mu[p] = -0.02 + 0.2 * static_cast<double>(p % 61) / 61.;
      add_one("equation_of_state/" + type, "particle", [=]() mutable {
        for (std::size_t p = 0; p < n_points; p += n_lanes)
          {
            const Lanes m = load<Lanes>(&mu[p]), pressure = eos.pressure(m);
            store(pressure + sqrt(eos.sound_speed_squared(m, pressure)), &sink[p]);
          }
        benchmark::DoNotOptimize(sink.data());
        benchmark::ClobberMemory();
      });
    }
  } // namespace

  void add_material_benchmarks()
  {
    add_plane_stress("elastic", HardeningLaw::linear, false);
    add_plane_stress("perfect", HardeningLaw::perfect, true);
    add_plane_stress("linear", HardeningLaw::linear, true);
    add_plane_stress("johnson_cook", HardeningLaw::johnson_cook, true);
    add_radial("elastic", HardeningLaw::linear, false);
    add_radial("linear", HardeningLaw::linear, true);
    add_radial("johnson_cook", HardeningLaw::johnson_cook, true);
    for (const char *type : {"linear", "murnaghan", "polynomial", "us-up", "porous", "tabulated"})
      add_equation_of_state(type);
  }
} // namespace birdstrike::benchmarks
