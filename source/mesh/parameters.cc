#include <birdstrike/mesh/parameters.h>

#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    const NamedChoices<MeshGenerator> generators{
      {"flat plate", MeshGenerator::flat_plate}, {"blade", MeshGenerator::blade}, {"file", MeshGenerator::file}};
    const NamedChoices<CamberLine> camber_lines{{"circular arc", CamberLine::circular_arc},
                                                {"parabola", CamberLine::parabola}};

    using namespace dealii::Patterns;

    const double tiny = 1e-12; ///< smallest length that is told from zero, m

    void declare_grid(dealii::ParameterHandler &prm, MeshParameters &p)
    {
      prm.add_parameter("Length", p.length, "Span of the built-in plate or blade, from its root. [m]", Double(tiny));
      prm.add_parameter("Chord", p.chord,
                        "Chord of the built-in plate, centred on y = 0; of the blade where its chord law is 1. [m]",
                        Double(tiny));
      prm.add_parameter("Elements along span", p.n_span, "Number of elements of the built-in part along x. [-]",
                        Integer(1, 100000));
      prm.add_parameter("Elements along chord", p.n_chord, "Number of elements of the built-in part along y. [-]",
                        Integer(1, 100000));
      prm.add_parameter("Span grading", p.span_grading,
                        "Length of the last element at the tip over the first at the root, geometric between them. [-]",
                        Double(1e-3, 1e3));
      prm.add_parameter("Chord grading", p.chord_grading,
                        "Width of the last element at the trailing edge over the first at the leading edge. [-]",
                        Double(1e-3, 1e3));
      prm.add_parameter("Layers", p.n_layers, "Number of solid elements through the thickness of a built-in part. [-]",
                        Integer(1, 1000));
      prm.add_parameter("Layer grading", p.layer_grading,
                        "Thickness of the middle layers of solid elements over the outermost ones, geometric between "
                        "them; symmetric about the mid-surface. [-]",
                        Double(1e-3, 1e3));
    }

    void declare_profile(dealii::ParameterHandler &prm, MeshParameters::Profile &p)
    {
      prm.enter_subsection("Profile");
      prm.add_parameter("Root radius", p.root_radius,
                        "Distance of the blade's root from the axis of the engine, which is y; the root lies at this "
                        "x. [m]",
                        Double(0.));
      prm.add_parameter("Chord law", p.chord,
                        "Chord of the section over Mesh/Chord, a formula in the normalised span s (0 root, 1 tip). [-]",
                        Anything());
      prm.add_parameter("Stagger", p.stagger,
                        "Angle of the chord to the axis y, turned towards z, a formula in s. [degree]", Anything());
      prm.add_parameter("Camber", p.camber,
                        "Largest height of the camber line over the chord, towards the normal, a formula in s between "
                        "-0.3 and 0.3; the camber angle of an arc is 4 atan(2 camber). [-]",
                        Anything());
      declare_choice(prm, "Camber line", p.camber_line, camber_lines, "Shape of the camber line. [-]");
      prm.add_parameter("Stacking point", p.stacking_point,
                        "Share of the chord, from the leading edge, at which sections are threaded on the radial "
                        "line. [-]",
                        Double(0., 1.));
      prm.add_parameter("Sweep", p.sweep, "Shift of the sections along the axis y, a formula in s. [m]", Anything());
      prm.add_parameter("Lean", p.lean, "Shift of the sections along z, a formula in s. [m]", Anything());
      prm.leave_subsection();
    }

    void declare_row(dealii::ParameterHandler &prm, MeshParameters::Row &p)
    {
      prm.enter_subsection("Row");
      prm.add_parameter("Blades", p.n_blades,
                        "Number of blades like the built-in one, turned about Spin/Axis through Spin/Centre; each that "
                        "is not rigid is computed. [-]",
                        Integer(1, 1000));
      prm.add_parameter("Pitch", p.pitch,
                        "Angle from one blade to the next, positive about the axis: of a fan of 22 blades 360/22. "
                        "[degree]",
                        Double(-180., 180.));
      prm.add_parameter("Place", p.place,
                        "Which of the row, 1 the first, lies as the other entries of Mesh say: aim, root and tip are "
                        "this blade's. [-]",
                        Integer(1, 1000));
      prm.add_parameter("Rigid", p.rigid,
                        "Places of blades that are rigid and follow the hub, '1 3'; they meet the bird and the other "
                        "blades and cost no element. [-]",
                        Anything());
      prm.leave_subsection();
    }

    void require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw InputError("Blade/" + message);
    }
  } // namespace

  void MeshParameters::declare(dealii::ParameterHandler &prm)
  {
    MeshParameters &p = *this;
    prm.enter_subsection("Mesh");
    declare_choice(
      prm, "Generator", p.generator, generators,
      "Where the blade comes from: the built-in plate (x span, y chord, z normal), the built-in blade (the same, "
      "twisted, tapered and cambered by the laws of Profile), both with boundary ids 0 root, 1 tip, 2 leading edge, 3 "
      "trailing edge, or a file. [-]");
    declare_grid(prm, p);
    prm.add_parameter(
      "File", p.file,
      "Quadrilateral surface mesh of a shell, hexahedral volume mesh of a solid: .msh (Gmsh 2 or 4), "
      ".inp (Abaqus or UCD), .k .key .dyn (LS-DYNA) or .vtk. Its named groups (physical lines, solid: "
      "surfaces; node sets, surfaces, segments) are boundaries, unlabelled: 0; physical surfaces (solid: "
      "volumes), element sets and parts are materials. Entries take their names or ids. A relative path is meant from "
      "the folder of the parameter file that says it, else from the working directory (with a warning); one of --set "
      "from the working directory first. The run folder keeps a copy. [-]",
      FileName());
    prm.add_parameter("Parts", p.parts,
                      "Parts of the file that are the blade, by name or id, 'airfoil, 3': parts and sets of LS-DYNA, "
                      "element sets, parts and instances of Abaqus, physical groups of Gmsh, material numbers of VTK. "
                      "Others are dropped with their nodes. Empty: all. [-]",
                      Anything());
    prm.add_parameter("File scale", p.file_scale, "Metres per length unit of the file, e.g. 0.001. [m]", Double(tiny));
    prm.add_parameter(
      "Top", p.top,
      "Direction 'x y z' that the top face of a shell from a file looks into on the mean: pressure acts "
      "along it, plies are stacked towards it. Empty: +z; where the mean normal has no such component "
      "(0.01) +y, else +x. [-]",
      Anything());
    prm.add_parameter("Material boxes", p.material_boxes,
                      "Material ids of the cells whose centre lies in a box: 'xmin ymin zmin xmax ymax zmax: 1; ...'; "
                      "other cells keep theirs, 0 in built-in parts. See Section 1. [m]",
                      Anything());
    prm.add_parameter("Material patches", p.material_patches,
                      "Material ids of patches of a built-in part, in shares of its span (0 root, 1 tip) and chord (0 "
                      "leading edge, 1 trailing edge): 's0 s1 c0 c1: 1; ...', a sheath '0 1 0 0.1: 1'. Lines of nodes "
                      "lie on their borders, so that each keeps its size on any mesh; boxes come after them. [-]",
                      Anything());
    declare_profile(prm, p.profile);
    declare_row(prm, p.row);
    prm.leave_subsection();
  }

  void ThicknessParameters::declare(dealii::ParameterHandler &prm)
  {
    ThicknessParameters &p = *this;
    prm.enter_subsection("Thickness");
    prm.add_parameter("Value", p.value, "Thickness, a number or a formula in x, y, z on the mid-surface. [m]",
                      Anything());
    prm.add_parameter(
      "By material", p.by_material,
      "Thickness of the cells with a material id or name, which replaces the value: '1: 0.004; root_block: 0.006'; "
      "built-in parts have the id 0. [m]",
      Anything());
    prm.add_parameter(
      "Table", p.table,
      "File with the thickness of a shell at its nodes, which replaces the value: rows 'x y z thickness' in "
      "m, or 'node thickness' with the node's id in the mesh file. Its path is meant as that of Mesh/File. [-]",
      FileName());
    prm.add_parameter(
      "Maximum", p.maximum,
      "Largest thickness of the section, a formula in the normalised span s (0 root, 1 tip); replaces the value by a "
      "profile along the chord, a parabola to either side of the largest thickness. On a shell from a file s is the "
      "share "
      "of the distance from the root in those from root and tip, and leading the edge that reports call so; empty: the "
      "value. [m]",
      Anything());
    prm.add_parameter("Leading edge", p.leading_edge,
                      "Thickness at the leading edge over Maximum, a formula in s between 0 and 1. [-]", Anything());
    prm.add_parameter("Trailing edge", p.trailing_edge,
                      "Thickness at the trailing edge over Maximum, a formula in s between 0 and 1. [-]", Anything());
    prm.add_parameter("Maximum station", p.maximum_station,
                      "Share of the chord, from the leading edge, at which the section is thickest. [-]",
                      Double(0.01, 0.99));
    prm.leave_subsection();
  }

  GeometryParameters::Counts GeometryParameters::count_generated(const bool is_solid) const
  {
    if (mesh.generator == MeshGenerator::file)
      return {};
    const double n_chord = mesh.n_chord / (is_halved ? 2u : 1u), n_span = mesh.n_span, n_layers = mesh.n_layers,
                 n_blades = mesh.row.n_blades;
    return {n_blades * n_span * n_chord * (is_solid ? n_layers : 1.),
            n_blades * (n_span + 1.) * (n_chord + 1.) * (is_solid ? n_layers + 1. : 1.)};
  }

  std::vector<unsigned int> MeshParameters::Row::places() const
  {
    std::vector<unsigned int> all{place};
    for (unsigned int k = 1; k <= n_blades; ++k)
      if (k != place)
        all.push_back(k);
    return all;
  }

  std::vector<bool> MeshParameters::Row::is_rigid() const
  {
    const std::vector<unsigned int> named = parse_ids(rigid, "Blade/Mesh/Row/Rigid"), all = places();
    std::vector<bool>               result;
    for (const unsigned int k : all)
      result.push_back(std::ranges::find(named, k) != named.end());
    for (const unsigned int k : named)
      require(std::ranges::find(all, k) != all.end(), "Mesh/Row/Rigid: the row has no place " + std::to_string(k) +
                                                        ".\nGive places from 1 to Mesh/Row/Blades.");
    require(!result.front(), "Mesh/Row/Rigid: the blade in Mesh/Row/Place is what root and tip are reported of, and "
                             "cannot be rigid.\nLeave it out, or set Place to an elastic one.");
    return result;
  }

  std::vector<double> MeshParameters::Row::angles() const
  {
    std::vector<double> all;
    for (const unsigned int k : places())
      all.push_back((static_cast<double>(k) - place) * pitch * std::numbers::pi / 180.);
    return all;
  }

  void GeometryParameters::check_row() const
  {
    const MeshParameters::Row &row = mesh.row;
    row.is_rigid();
    require(row.place <= row.n_blades, "Mesh/Row/Place: there are " + std::to_string(row.n_blades) +
                                         " blades in the row.\nGive a place from 1 to that.");
    if (row.n_blades == 1)
      return;
    require(mesh.generator != MeshGenerator::file,
            "Mesh/Row/Blades: a file holds one blade, which is not repeated.\nLet Mesh/Generator be blade or flat "
            "plate, or set Blades to 1.");
    require(!is_halved, "Mesh/Row/Blades: a row has no plane of symmetry.\nSet Case/Symmetry plane to none.");
    require(row.pitch != 0., "Mesh/Row/Pitch: the blades lie in one another.\nGive the angle from one to the next.");
    require(std::abs(row.pitch) * row.n_blades <= 360. * (1. + 1e-9),
            "Mesh/Row/Pitch: " + std::to_string(row.n_blades) +
              " blades at this pitch go more than once around.\n"
              "Give fewer blades, or 360 over the number of those of the fan.");
  }

  void GeometryParameters::check_geometry() const
  {
    require(mesh.material_patches.empty() || mesh.generator != MeshGenerator::file,
            "Mesh/Material patches: a mesh from a file has no lines of its own along span and chord.\nGive its groups "
            "material ids in the file, or Mesh/Material boxes.");
    require(mesh.parts.empty() || mesh.generator == MeshGenerator::file,
            "Mesh/Parts: a built-in part has no parts.\nSet Mesh/Generator to file, or leave Parts empty.");
    require(thickness.table.empty() || thickness.maximum.empty(),
            "Thickness: Table and Maximum are both given.\nKeep one of them.");
    if (thickness.maximum.empty())
      return;
    require(thickness.value == ThicknessParameters().value,
            "Thickness: Value and Maximum are both given.\nKeep one: Value for a formula in x, y, z, Maximum for a "
            "profile along the chord.");
  }
} // namespace birdstrike
