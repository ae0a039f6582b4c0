#pragma once

#include <birdstrike/io/input_files.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace birdstrike
{
  /// Key "end/reason" of a run that was ended from outside: its results are not those of its parameters.
  inline constexpr const char *stopped_by_signal = "stopped by a signal";
  /// The same of a run whose time was up on the wall's clock.
  inline constexpr const char *stopped_by_clock = "maximum wall time reached";

  /// Work that a run did not do: what, how much of it, and the share of the run time that it would have been (NaN: no
  /// estimate).
  struct SkippedWork
  {
    std::string what;
    double      count = 0.;
    std::string unit;
    double      saved = 0.;
  };

  /// The outcome of a run in stable keys for scripts (summary.json): SI units, absent parts are zero, a quantity that
  /// could not be computed (NaN) becomes null. The members are the keys.
  struct Summary
  {
    std::string case_name; ///< key "case"
    struct
    {
      std::string version, build; ///< as in ProgramIdentity
    } program;
    std::vector<InputFile> inputs; ///< as they were when the run read them
    struct
    {
      double      time = 0.; ///< s
      std::string reason;
    } end;
    struct
    {
      std::string kind                 = "none"; ///< shell, solid, rigid, none
      std::size_t elements             = 0;
      std::size_t nodes                = 0;
      double      mass                 = 0.; ///< kg
      double      added_rotary_inertia = 0.; ///< by selective mass scaling, share of its own
    } blade;
    struct
    {
      std::size_t           particles      = 0;
      double                mass           = 0.; ///< kg
      double                kinetic_energy = 0.; ///< J, at the start
      std::array<double, 3> momentum{};          ///< N s, at the start
    } bird;
    struct
    {
      std::size_t blade = 0;
      std::size_t bird  = 0;
    } steps;
    struct
    {
      /// m, s, m: mid-chord, positive away from the struck side (blade/orientation.h); the peak is the largest absolute
      /// value over all macro steps, with its sign.
      double peak = 0., peak_time = 0., final = 0.;
    } tip;
    struct
    {
      // largest absolute values over all macro steps
      double peak_normal_stress      = 0.; ///< Pa
      double peak_normal_stress_time = 0.; ///< s
      double peak_moment             = 0.; ///< N m
      double peak_force              = 0.; ///< N, norm of normal and transverse force
    } root;
    struct
    {
      std::array<double, 3> impulse{};                         ///< N s, on the blade
      double                peak_force                   = 0.; ///< N, norm of the sum, over every evaluation of contact
      double                peak_force_time              = 0.; ///< s
      double                max_penetration              = 0.; ///< m
      double                max_penetration_over_spacing = 0.;
    } contact;
    struct
    {
      double                max_strain = 0.;
      std::array<double, 3> position{}; ///< m, reference position of the largest strain
      double                work = 0.;  ///< J
    } plastic;
    struct
    {
      std::size_t elements  = 0;
      std::size_t collapsed = 0;  ///< of these, not by damage but by the smallest step
      std::size_t at_root   = 0;  ///< of the failed, at the root section
      double      mass      = 0.; ///< kg, of failed elements
      double      free_mass = 0.; ///< kg, on nodes without any element left
      double      energy    = 0.; ///< J, eroded
    } failed;
    struct
    {
      double                        initial                     = 0.; ///< J
      double                        final                       = 0.; ///< J
      double                        max_relative_error          = 0.;
      double                        max_hourglass_over_internal = 0.;
      double                        bird_internal               = 0.; ///< J, by the energy equation; no part
      std::map<std::string, double> parts;                            ///< J at the end, e.g. "blade_elastic"
      std::map<std::string, double> error_origins;                    ///< J at the end, by blade, bird, contact, steps
    } energy;
    struct
    {
      double max_relative_error = 0.;
    } momentum, angular_momentum;
    struct
    {
      std::size_t particles = 0;
      double      mass      = 0.; ///< kg
      double      energy    = 0.; ///< J
    } retired;
    std::vector<SkippedWork> skipped; ///< by the key `what`
    struct
    {
      double      wall                 = 0.; ///< s
      std::size_t threads              = 1;
      double      ns_per_particle_step = 0.;
      double      ns_per_element_step  = 0.;
      std::size_t peak_memory          = 0; ///< bytes, resident
    } cost;
  };

  void to_json(nlohmann::json &json, const Summary &summary);

  /// The text of summary.json.
  std::string to_text(const Summary &summary);

  /// Largest resident memory of this process so far (bytes).
  std::size_t compute_peak_memory();
} // namespace birdstrike
