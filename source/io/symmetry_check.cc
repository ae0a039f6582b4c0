#include <birdstrike/blade/expression.h>
#include <birdstrike/blade/text_lists.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/symmetry_check.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    void refuse_unless(const bool is_symmetric, const std::string &entry, const std::string &allowed)
    {
      if (!is_symmetric)
        throw InputError(entry + " is not symmetric about the plane y = 0.\n  Allowed: " + allowed +
                         ".\n  Action: change it, or set Case/Symmetry plane to none.");
    }

    /// Whether each component of a formula is even (+1) or odd (-1) in y; sampled on the unit plate and three times.
    void require_parity(const std::string &text, const std::vector<int> &parity, const std::string &entry)
    {
      if (!is_present(text))
        return;
      const Expression expression(text, parity.size(), entry);
      bool             is_symmetric = true;
      for (const double x : {0., 0.03, 0.11, 0.29})
        for (const double y : {0.002, 0.017, 0.041})
          for (const double t : {0., 0.4e-3, 3e-3})
            for (unsigned int c = 0; c < parity.size(); ++c)
              {
                const double here[3] = {x, y, 0.}, there[3] = {x, -y, 0.};
                const double a = expression.value(here, t, c), b = parity[c] * expression.value(there, t, c);
                is_symmetric = is_symmetric && std::abs(a - b) <= 1e-12 * (std::abs(a) + std::abs(b));
              }
      refuse_unless(is_symmetric, "Blade/" + entry, "the same at y and -y (a y component: with the other sign)");
    }

    void require_symmetric_bird(const BirdParameters &bird)
    {
      const auto  &v     = bird.velocity;
      const double speed = std::hypot(v[0], v[1], v[2]);
      refuse_unless(v[1] == 0., "Bird/Velocity", "a y component of 0");
      refuse_unless(bird.aim_point[1] == 0., "Bird/Aim point", "y = 0");
      refuse_unless(bird.chordwise_offset == 0., "Bird/Chordwise offset", "0");
      // along the span, yaw turns about y and pitch about z; elsewhere yaw turns out of the plane
      const bool flies_along_span = std::abs(v[0]) > 0.999999 * speed && speed > 0.;
      refuse_unless((flies_along_span ? bird.pitch : bird.yaw) == 0., flies_along_span ? "Bird/Pitch" : "Bird/Yaw",
                    "0: the bird's axis lies in the plane");
      refuse_unless(!bird.is_periodic(1), "Bird/Periodic directions", "none, x, z");
    }

    void require_symmetric_supports(const BladeParameters::Supports &supports)
    {
      constexpr unsigned int leading = 2, trailing = 3; // boundaries of the flat plate
      for (const auto &[ids, entry] : {std::pair{supports.clamped, "Supports/Clamped"}, {supports.hub, "Supports/Hub"}})
        {
          const auto list = parse_ids(ids, entry);
          const auto has = [&](const unsigned int id) { return std::find(list.begin(), list.end(), id) != list.end(); };
          refuse_unless(has(leading) == has(trailing), std::string("Blade/") + entry,
                        "both edges (2 and 3) or neither");
        }
      refuse_unless(supports.held.empty(), "Blade/Supports/Held", "nothing, with a symmetry plane");
      refuse_unless(supports.held_boxes.empty(), "Blade/Supports/Held boxes", "nothing, with a symmetry plane");
    }

    void require_symmetric_blade(const BladeParameters &blade)
    {
      if (blade.kind == "rigid")
        refuse_unless(blade.rigid.centre[1] == 0. && blade.rigid.normal[1] == 0., "Blade/Rigid/Centre or Normal",
                      "a y component of 0");
      if (blade.kind != "shell" && blade.kind != "solid")
        return;
      refuse_unless(blade.mesh.generator != "flat plate" ||
                      (blade.mesh.chord_grading == 1. && blade.mesh.n_chord % 2 == 0),
                    "Blade/Mesh", "an even number of equal elements along the chord");
      require_parity(blade.thickness.value, {1}, "Thickness/Value");
      require_parity(blade.loads.pressure, {1}, "Loads/Pressure");
      require_parity(blade.loads.initial_velocity, {1, -1, 1}, "Loads/Initial velocity");
      require_parity(blade.loads.initial_spin, {-1, 1, -1}, "Loads/Initial spin"); // a spin is an axial vector
      refuse_unless(blade.loads.point_loads.empty(), "Blade/Loads/Point loads", "nothing, with a symmetry plane");
      require_symmetric_supports(blade.supports);
    }

    void require_visible(const CaseParameters &parameters)
    {
      for (const auto &[name, where] : parse_pairs(parameters.blade.probes, "Probes"))
        refuse_unless(parse_numbers(where, 3, "Probes")[1] >= 0., "Blade/Probes: '" + name + "'",
                      "y >= 0, the half that is computed");
      for (const PressurePatch &patch : parameters.contact.pressure_patches())
        refuse_unless(patch.centre[1] == 0. || patch.centre[1] >= patch.radius,
                      "Contact/Pressure patches: '" + patch.name + "'",
                      "a centre at y = 0, or a disc that lies in y >= 0");
    }
  } // namespace

  void require_symmetry(const CaseParameters &parameters)
  {
    if (parameters.bird.enabled)
      require_symmetric_bird(parameters.bird);
    require_symmetric_blade(parameters.blade);
    require_visible(parameters);
  }
} // namespace birdstrike
