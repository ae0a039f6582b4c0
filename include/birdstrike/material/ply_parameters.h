#pragma once

#include <birdstrike/material/metal_constants.h>
#include <birdstrike/material/ply.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Declares the constants of a ply in the section that the caller has entered; zero: not given.
  void declare_ply(dealii::ParameterHandler &prm, Ply &ply);

  /// The constants that are given, and those of `others` for the rest.
  Ply with_others(const Ply &given, const Ply &others);

  /// Throws InputError, which names the entries with `where` they stand, for constants that are missing, for strengths
  /// of which only some are given, and for a stiffness that would store negative energy.
  void check_ply(const Ply &ply, const std::string &where);

  /// The constants that the ply's laws use, for reports.
  std::vector<MetalConstant> constants_in_use(const Ply &ply);

  /// One line: "1600 kg/m^3, E1 138 GPa, E2 9 GPa, nu12 0.3, G12 6.9 GPa, ... does not fail".
  std::string describe(const Ply &ply);
} // namespace birdstrike
