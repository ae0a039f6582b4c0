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

    std::size_t material = 0; ///< of PlyStack::materials
  };

  /// A material that plies name.
  struct PlyMaterial
  {
    std::string name;    ///< empty: the laminate's own constants
    std::string entries; ///< where they stand in Blade/Laminate: "Material 2/"; empty of the laminate's own
    Ply         ply;

    bool operator==(const PlyMaterial &) const = default;
  };

  struct PlyStack
  {
    std::vector<PlyLayer>    layers; ///< from the bottom (the side that the normal leaves) to the top; shares sum to 1
    std::vector<PlyMaterial> materials; ///< in the order in which layers name them
  };

  /// A laminate as the user gives it: the stack, its direction and its ply. In sections of material ids, what is zero
  /// or empty is the blade's.
  struct LaminateParameters
  {
    std::string  plies;               ///< "0: 0.125e-3; 45: 0.125e-3: glass" or "[0/45/-45/90]2s"; empty: none
    std::string  reference_direction; ///< three numbers
    unsigned int n_per_ply = 0;
    Ply          ply;
    double       degradation_time = 0.; ///< s
    double       failed_share     = 0.;
    double       smallest_step    = 0.;

    double matrix_failure_strain = 0.; ///< of an element without any matrix left; the blade's 0: never

    std::array<PlyMaterial, 4> materials; ///< the blade's, for plies of all sections; without a name: not there

    bool operator==(const LaminateParameters &) const = default;

    static LaminateParameters of_blade(); ///< the blade's own, with the defaults that sections refer to

    bool is_given() const;
    /// With what `blade` has where this has nothing.
    LaminateParameters with_others(const LaminateParameters &blade) const;

    void declare(dealii::ParameterHandler &prm);
    void declare_materials(dealii::ParameterHandler &prm); ///< of the blade

    /// Throws InputError, which names the entries with `where` they stand, as the others do.
    PlyStack              stack(const std::string &where = "Blade/Laminate/") const;
    std::vector<PlyLayer> layers(const std::string &where = "Blade/Laminate/") const
    {
      return stack(where).layers;
    }
    std::array<double, 3> reference(const std::string &where = "Blade/Laminate/") const;
    void                  check(const std::string &where) const;
    /// Every ply looks the same from the other side of the plane y = 0.
    bool is_symmetric_about_y() const;

    bool   can_fail() const;      ///< some ply
    double density() const;       ///< kg/m^3, mean over the thickness
    double largest_young() const; ///< Pa, along the fibres of some ply

  private:
    void check_materials() const;
  };

  /// One line: "16 plies, [0/45/-45/90]2s, 1600 kg/m^3, ...".
  std::string describe(const LaminateParameters &laminate);
} // namespace birdstrike
