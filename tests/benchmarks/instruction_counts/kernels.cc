#include "bird_workload.h"
#include "contact_workload.h"
#include "shell_workload.h"
#include "solid_workload.h"

#include <gnu/libc-version.h>

#include <cstdio>
#include <functional>
#include <map>
#include <string>

using namespace birdstrike;
using namespace birdstrike::benchmarks;

namespace
{
  constexpr std::size_t n_steps = 20;

  /// A fixed piece of work and how many units (particle-steps, element-steps, near points) it is.
  struct Piece
  {
    std::function<void()> run;
    std::size_t           n_units;
  };

  Piece make_rates(const std::string &formulation)
  {
    const auto bird = std::make_shared<BirdWorkload>(1000, 1, formulation);
    return {[bird] { bird->bird.compute_rates(); }, bird->n()};
  }

  Piece make_particle_step()
  {
    const auto bird = std::make_shared<BirdWorkload>(1000, 1);
    return {[bird] {
              for (std::size_t k = 0; k < n_steps; ++k)
                bird->step();
            },
            n_steps * bird->n()};
  }

  Piece make_list()
  {
    const auto lists = std::make_shared<ListWorkload>(1000, 1);
    return {[lists] { lists->list.update(lists->particles, lists->source.pool); }, lists->source.n()};
  }

  Piece make_elements(const ShellCase &what)
  {
    const auto shell = std::make_shared<ShellWorkload>(400, 1, what);
    return {[shell] { shell->step(); }, shell->n()};
  }

  Piece make_bricks(const SolidCase &what)
  {
    const auto solid = std::make_shared<SolidWorkload>(400, 1, what);
    return {[solid] { solid->step(); }, solid->n()};
  }

  Piece make_contact(const std::size_t n_far_layers, const bool is_new_list)
  {
    const auto contact = std::make_shared<ContactWorkload>(400, n_far_layers, 1);
    return {[contact, is_new_list] { is_new_list ? contact->search() : contact->compute_forces(); }, contact->n_near()};
  }

  const std::map<std::string, std::function<Piece()>> &pieces()
  {
    using enum ShellFormulation;
    static const std::map<std::string, std::function<Piece()>> all = {
      {"particle_step", make_particle_step},
      {"rates_riemann", [] { return make_rates("riemann"); }},
      {"rates_linear", [] { return make_rates("linear"); }},
      {"rates_strong", [] { return make_rates("strong"); }},
      {"rates_standard", [] { return make_rates("standard"); }},
      {"list_build", make_list},
      {"element_elastic",
       [] {
         return make_elements({one_point_physical, 5, false});
       }},
      {"element_plastic",
       [] {
         return make_elements({one_point_physical, 5, true});
       }},
      {"element_belytschko_tsay",
       [] {
         return make_elements({belytschko_tsay, 5, false});
       }},
      {"element_fully_integrated",
       [] {
         return make_elements({fully_integrated, 5, false});
       }},
      {"element_fully_integrated_plastic",
       [] {
         return make_elements({fully_integrated, 5, true});
       }},
      {"brick_elastic",
       [] {
         return make_bricks({SolidFormulation::one_point, false});
       }},
      {"brick_plastic",
       [] {
         return make_bricks({SolidFormulation::one_point, true});
       }},
      {"brick_solid_shell_elastic",
       [] {
         return make_bricks({SolidFormulation::solid_shell, false});
       }},
      {"brick_solid_shell_plastic",
       [] {
         return make_bricks({SolidFormulation::solid_shell, true});
       }},
      {"brick_b_bar_plastic",
       [] {
         return make_bricks({SolidFormulation::b_bar, true});
       }},
      {"near_point", [] { return make_contact(0, false); }},
      {"contact_search", [] { return make_contact(8, true); }}};
    return all;
  }
} // namespace

/// Only what happens in here is counted, and each call for itself: valgrind --tool=callgrind
/// --toggle-collect=count_instructions --dump-after=count_instructions.
extern "C" [[gnu::noinline]] void count_instructions(const std::function<void()> *run)
{
  (*run)();
}

/// Runs every piece once; prints compiler and library, then name and number of units of each piece.
int main()
{
  std::printf("GCC %s, glibc %s, %zu doubles\n", __VERSION__, gnu_get_libc_version(), n_lanes);
  for (const auto &[name, make_piece] : pieces())
    {
      const Piece piece = make_piece();
      piece.run(); // arrays have their size, lists their length
      count_instructions(&piece.run);
      std::printf("%s %zu\n", name.c_str(), piece.n_units);
    }
  return 0;
}
