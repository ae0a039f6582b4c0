#include "study.h"

#include <birdstrike/core/errors.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace birdstrike::studies
{
  namespace
  {
    const char *const usage =
      "quadratic_bricks VERB KIND NxMxL [thickness (m) [impulse (N s) [end time (s)]]]\n"
      "writes a line of CSV: verb, kind, mesh, number of elements, and of\n"
      "  frequencies   the first five of the plate clamped at one end (Hz)\n"
      "  step          stable step: exact, and the element's own bound or 0 (s)\n"
      "  modes         motions of the free plate that strain nothing\n"
      "  check         bricks, 2x2x2 at least: errors of the patch test and of a turn of strained ones\n"
      "  cost          ns per element and step, elastic and plastic; flops of quadratic bricks\n"
      "  impulse       tip at the end (mm), plastic work, hourglass energy (J), energy error over work,\n"
      "                steps, time of the forces (s), ns per element and step, largest tip deflection\n"
      "                (mm) and when (ms)\n"
      "KIND: shell, one-point, b-bar, quadratic-RULE; RULE: g2, g3, gl3, g2xg3, g2xg5, or one of these and -bare\n";

    Metal make_titanium(const bool is_elastic)
    {
      Metal metal;
      metal.density           = 4430.;
      metal.elasticity        = {113.8e9, 0.342};
      metal.hardening.law     = is_elastic ? HardeningLaw::elastic : HardeningLaw::linear;
      metal.hardening.yield   = 880e6;
      metal.hardening.modulus = 1.25e9;
      return metal;
    }

    std::array<unsigned int, 3> parse_mesh(const char *text)
    {
      std::array<unsigned int, 3> n{};
      char                        rest = 0;
      if (std::sscanf(text, "%ux%ux%u%c", &n[0], &n[1], &n[2], &rest) != 3 || n[0] * n[1] * n[2] == 0)
        throw InputError(std::string("A mesh is given as 14x4x1, not \"") + text + "\".");
      return n;
    }

    double parse_positive(const char *text)
    {
      char        *end   = nullptr;
      const double value = std::strtod(text, &end);
      if (!(value > 0.) || *end != 0)
        throw InputError(std::string("A positive number is needed, not \"") + text + "\".");
      return value;
    }

    void print_frequencies(Part &part)
    {
      for (const double f : compute_frequencies(part, 5))
        std::printf(",%.3f", f);
    }

    void print_step(Part &part)
    {
      std::vector<double> mode, position;
      for (const Point3 &x : part.nodes)
        position.insert(position.end(), {x[0], x[1], x[2]});
      const double exact = compute_stable_step(part, position.data(), 400, mode);
      std::printf(",%.5e,%.5e", exact, part.stable_step_bound());
    }

    void print_cost(const std::string &kind, Part &elastic, Part &plastic)
    {
      std::printf(",%.1f,%.1f", measure_cost(elastic, false), measure_cost(plastic, true));
      if (kind.rfind("quadratic-", 0) == 0)
        for (const bool is_plastic : {false, true})
          std::printf(",%.0f", count_quadratic_flops(kind.substr(10), is_plastic));
    }

    void print_impulse(Part &part, const Plate &plate, const Pulse &pulse, const double end_time)
    {
      const ImpulseResult r = run_impulse(part, plate, pulse, end_time);
      std::printf(",%.4f,%.3f,%.3f,%.2e,%zu,%.4f,%.1f,%.4f,%.4f", 1e3 * r.tip, r.plastic_work, r.hourglass_energy,
                  r.energy_error, r.n_steps, r.seconds, 1e9 * r.seconds / double(r.n_steps * part.n_elements),
                  1e3 * r.peak, 1e3 * r.peak_time);
    }

    void run(const int argc, char **argv)
    {
      if (argc < 4)
        throw InputError(usage);
      const std::string verb = argv[1], kind = argv[2];
      Plate             plate;
      plate.n         = parse_mesh(argv[3]);
      plate.thickness = argc > 4 ? parse_positive(argv[4]) : plate.thickness;
      Pulse pulse;
      pulse.impulse         = argc > 5 ? parse_positive(argv[5]) : pulse.impulse;
      const double end_time = argc > 6 ? parse_positive(argv[6]) : 2e-3;
      ThreadPool   pool;
      const auto make = [&](const bool is_elastic) { return make_part(kind, plate, make_titanium(is_elastic), pool); };
      const auto part = make(verb != "impulse");
      std::printf("%s,%s,%s,%zu", verb.c_str(), kind.c_str(), argv[3], part->n_elements);
      if (verb == "frequencies")
        print_frequencies(*part);
      else if (verb == "step")
        print_step(*part);
      else if (verb == "modes")
        std::printf(",%u", count_free_modes(*part));
      else if (verb == "check")
        {
          const double patch = check_patch(*part, plate);
          std::printf(",%.1e,%.1e", patch, check_turning(*part));
        }
      else if (verb == "cost")
        print_cost(kind, *part, *make(false));
      else if (verb == "impulse")
        print_impulse(*part, plate, pulse, end_time);
      else
        throw InputError(usage);
      std::printf("\n");
    }
  } // namespace
} // namespace birdstrike::studies

int main(int argc, char **argv)
{
  try
    {
      birdstrike::studies::run(argc, argv);
    }
  catch (const birdstrike::InputError &error)
    {
      std::cerr << error.what() << '\n';
      return 2;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << '\n';
      return 3;
    }
}
