#pragma once

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Where the mesh of a blade comes from.
  enum class MeshGenerator
  {
    flat_plate,
    blade,
    file
  };

  enum class CamberLine
  {
    circular_arc,
    parabola
  };

  /// Subsection "Mesh" of section "Blade" of the parameter file.
  ///
  /// Coordinates of the built-in flat plate: x = span from the root (x = 0), y = chord, centred, z = normal. Its
  /// boundary ids: 0 root, 1 tip, 2 leading edge (y = -chord/2), 3 trailing edge; as a solid also 5 and 6, the faces on
  /// the side of minus and plus the normal. The built-in blade has the same ids; see BladeShape. Formulas are kept as
  /// text; their syntax is checked where they are used, always before the first step.
  struct MeshParameters
  {
    /// Laws of the built-in blade, formulas of the normalised span s: 0 at the root, 1 at the tip.
    struct Profile
    {
      double      root_radius    = 0.;  ///< m
      std::string chord          = "1"; ///< of the section over Mesh::chord
      std::string stagger        = "0"; ///< degrees
      std::string camber         = "0"; ///< largest height of the camber line over the chord
      CamberLine  camber_line    = CamberLine::circular_arc;
      double      stacking_point = 0.5; ///< share of the chord
      std::string sweep          = "0"; ///< m
      std::string lean           = "0"; ///< m
    };

    /// Blades like the built-in part, turned about an axis.
    struct Row
    {
      unsigned int          n_blades = 1;
      double                pitch    = 360. / 22.; ///< degrees, from one to the next
      unsigned int          place    = 1;          ///< of the blade that lies as the other entries say
      std::string           rigid;                 ///< places of blades that are rigid, as their hub is
      std::array<double, 3> axis{{0., 0., 1.}};    ///< of Blade/Spin, set by the blade, as the next
      std::array<double, 3> centre{{0., 0., 0.}};  ///< m

      /// Of the blades in the order of the mesh: first the one that lies as the other entries say, then the others.
      std::vector<unsigned int> places() const;
      std::vector<double>       angles() const;   ///< rad, from the first one
      std::vector<bool>         is_rigid() const; ///< throws InputError for what names no place
    };

    MeshGenerator generator     = MeshGenerator::flat_plate;
    double        length        = 0.3112; ///< m
    double        chord         = 0.0889; ///< m
    unsigned int  n_span        = 28;
    unsigned int  n_chord       = 8;
    double        span_grading  = 1.; ///< longest over shortest element along the span, shortest at the root
    double        chord_grading = 1.; ///< longest over shortest element along the chord, shortest at the leading edge
    unsigned int  n_layers      = 1;  ///< of bricks through the thickness
    double        layer_grading = 1.; ///< middle over outermost layer
    Profile       profile;
    Row           row;
    std::string   file;
    std::string   parts;            ///< of the file that are the blade; empty: all
    double        file_scale = 1.;  ///< m per unit of the file
    std::string   top;              ///< "x y z", into which a shell's top face looks; empty: upwards
    std::string   material_boxes;   ///< "xmin ymin zmin xmax ymax zmax: 1; ..."
    std::string   material_patches; ///< "s0 s1 c0 c1: 1; ...", shares of span and chord of a built-in part

    void declare(dealii::ParameterHandler &prm); ///< in the handler's present section, "Blade"
  };

  /// Subsection "Thickness" of section "Blade".
  struct ThicknessParameters
  {
    std::string value = "0.00427"; ///< m, number or expression in x, y, z
    std::string by_material;       ///< "1: 0.004; 2: 0.003"
    std::string table;             ///< a file, of shells; see nodal_thickness.h

    /// Profile along the chord, formulas of s; empty: `value` holds.
    std::string maximum;                  ///< m
    std::string leading_edge    = "0.25"; ///< over the maximum
    std::string trailing_edge   = "0.25"; ///< over the maximum
    double      maximum_station = 0.5;    ///< share of the chord

    void declare(dealii::ParameterHandler &prm); ///< in the handler's present section, "Blade"
  };

  /// What gives a blade of finite elements its geometry.
  struct GeometryParameters
  {
    MeshParameters      mesh{};
    ThicknessParameters thickness{};
    bool                is_halved = false; ///< only y >= 0 is computed; set by the case

    /// Elements and nodes of what is computed, exactly; real numbers, for there may be more than an integer holds.
    struct Counts
    {
      double elements = 0., nodes = 0.;
    };
    /// Of a built-in part before it is built, as a shell or in layers of bricks; nothing of a file.
    Counts count_generated(bool is_solid) const;

    /// Rules between their entries. Throws InputError.
    void check_geometry() const;
    void check_row() const;
  };
} // namespace birdstrike
