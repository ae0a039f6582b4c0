#pragma once

#include <birdstrike/material/ply_parameters.h>

#include <array>
#include <string>
#include <vector>

namespace birdstrike
{
  /// One ply of a stack.
  struct PlyLayer
  {
    double angle; ///< degrees, of its fibres from the reference direction, about the normal of the shell
    double share; ///< of the thickness
  };

  /// A laminate as the user gives it: the stack, its direction and its ply. In sections of material ids, what is zero
  /// or empty is the blade's.
  struct LaminateParameters
  {
    std::string  plies;               ///< "0: 0.125e-3; 45: 0.125e-3" or "[0/45/-45/90]2s"; empty: no laminate
    std::string  reference_direction; ///< three numbers
    unsigned int n_per_ply = 0;
    Ply          ply;
    unsigned int n_degradation_steps = 0;
    double       failed_share        = 0.;
    double       smallest_step       = 0.;

    bool operator==(const LaminateParameters &) const = default;

    static LaminateParameters of_blade(); ///< the blade's own, with the defaults that sections refer to

    bool is_given() const;
    /// With what `blade` has where this has nothing.
    LaminateParameters with_others(const LaminateParameters &blade) const;

    void declare(dealii::ParameterHandler &prm);

    /// From the bottom (the side that the normal leaves) to the top; shares sum to 1. Throws InputError, which names
    /// the entries with `where` they stand, as the others do.
    std::vector<PlyLayer> layers(const std::string &where = "Blade/Laminate/") const;
    std::array<double, 3> reference(const std::string &where = "Blade/Laminate/") const;
    void                  check(const std::string &where) const;
    /// Every ply looks the same from the other side of the plane y = 0.
    bool is_symmetric_about_y() const;
  };

  /// One line: "16 plies, [0/45/-45/90]2s, 1600 kg/m^3, ...".
  std::string describe(const LaminateParameters &laminate);
} // namespace birdstrike
