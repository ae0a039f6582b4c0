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
      prm.add_parameter("Length", p.length, "Span of the built-in plate or blade, measured from its root. [m]",
                        Double(tiny));
      prm.add_parameter("Chord", p.chord,
                        "Chord of the built-in plate, centred on y = 0. For the built-in blade it is the chord where "
                        "Chord law is 1. [m]",
                        Double(tiny));
      prm.add_parameter("Elements along span", p.n_span, "Number of elements of the built-in part along x. [-]",
                        Integer(1, 100000));
      prm.add_parameter("Elements along chord", p.n_chord, "Number of elements of the built-in part along y. [-]",
                        Integer(1, 100000));
      prm.add_parameter("Span grading", p.span_grading,
                        "Ratio of element lengths: the last element at the tip over the first one at the root. The "
                        "lengths between them form a geometric series. [-]",
                        Double(1e-3, 1e3));
      prm.add_parameter(
        "Chord grading", p.chord_grading,
        "Ratio of element widths: the last element at the trailing edge over the first one at the leading edge. [-]",
        Double(1e-3, 1e3));
      prm.add_parameter("Layers", p.n_layers, "Number of solid elements through the thickness of a built-in part. [-]",
                        Integer(1, 1000));
      prm.add_parameter("Layer grading", p.layer_grading,
                        "Ratio of layer thicknesses of solid elements: the middle layers over the outermost ones. The "
                        "thicknesses between them form a geometric series and are symmetric about the mid-surface. [-]",
                        Double(1e-3, 1e3));
    }

    void declare_profile(dealii::ParameterHandler &prm, MeshParameters::Profile &p)
    {
      prm.enter_subsection("Profile");
      prm.add_parameter(
        "Root radius", p.root_radius,
        "Distance of the blade's root from the axis of the engine, which is y. The root lies at this x. [m]",
        Double(0.));
      prm.add_parameter(
        "Chord law", p.chord,
        "Ratio of the section's chord to Mesh/Chord: a formula in the normalised span s (0 root, 1 tip). [-]",
        Anything());
      prm.add_parameter("Stagger", p.stagger,
                        "Angle of the chord to the axis y, positive towards z: a formula in s. [degree]", Anything());
      prm.add_parameter(
        "Camber", p.camber,
        "Ratio of the camber line's largest height to the chord, positive towards the normal: a formula in s with "
        "values from -0.3 to 0.3. The camber angle of an arc is 4 atan(2 camber). [-]",
        Anything());
      declare_choice(prm, "Camber line", p.camber_line, camber_lines, "Shape of the camber line. [-]");
      prm.add_parameter(
        "Stacking point", p.stacking_point,
        "Point of each section on the radial stacking line, as a share of the chord from the leading edge. [-]",
        Double(0., 1.));
      prm.add_parameter("Sweep", p.sweep, "Shift of the sections along the axis y: a formula in s. [m]", Anything());
      prm.add_parameter("Lean", p.lean, "Shift of the sections along z: a formula in s. [m]", Anything());
      prm.leave_subsection();
    }

    void declare_row(dealii::ParameterHandler &prm, MeshParameters::Row &p)
    {
      prm.enter_subsection("Row");
      prm.add_parameter("Blades", p.n_blades,
                        "Number of blades in the row, all like the built-in one. The copies are rotated about "
                        "Spin/Axis through Spin/Centre. All blades are computed except those of the entry Rigid. [-]",
                        Integer(1, 1000));
      prm.add_parameter(
        "Pitch", p.pitch,
        "Angle from one blade to the next, positive about the axis, e.g. 360/22 for a fan of 22 blades. [degree]",
        Double(-180., 180.));
      prm.add_parameter("Place", p.place,
                        "Place in the row, from 1, of the blade that the other entries of Mesh describe. Aim, root and "
                        "tip are those of this blade. [-]",
                        Integer(1, 1000));
      prm.add_parameter("Rigid", p.rigid,
                        "Places of blades that are rigid and follow the hub, e.g. '1 3'. They take part in contact "
                        "with the bird and the other blades, and need no elements. [-]",
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
      "Source of the blade's mesh. flat plate: the built-in plate with x along the span, y along the chord and z "
      "normal. blade: the built-in plate, twisted, tapered and cambered by the laws of Profile. file: a mesh file. "
      "Built-in parts have the boundary ids 0 root, 1 tip, 2 leading edge and 3 trailing edge. [-]");
    declare_grid(prm, p);
    prm.add_parameter(
      "File", p.file,
      "Mesh file: a quadrilateral surface mesh for a shell, a hexahedral volume mesh for a solid. Formats: .msh (Gmsh "
      "2 or 4), .inp (Abaqus or UCD), .k .key .dyn (LS-DYNA) and .vtk. Boundaries are the named groups of the file: "
      "physical lines (of a solid: physical surfaces), node sets, surfaces and segments. Sides without a label have "
      "the boundary id 0. Materials are physical surfaces (of a solid: physical volumes), element sets and parts. "
      "Other entries refer to boundaries and materials by name or id. A relative path starts at the folder of the "
      "parameter file that sets it. If there is no such file, it starts at the working directory, with a warning. A "
      "relative path of --set starts at the working directory first. The run folder keeps a copy of the file. [-]",
      FileName());
    prm.add_parameter("Parts", p.parts,
                      "Parts of the file that form the blade, by name or id, e.g. 'airfoil, 3'. LS-DYNA: parts and "
                      "sets. Abaqus: element sets, parts and instances. Gmsh: physical groups. VTK: material numbers. "
                      "All other parts are removed with their nodes. Empty: all parts. [-]",
                      Anything());
    prm.add_parameter("File scale", p.file_scale, "Length unit of the file in metres, e.g. 0.001 for millimetres. [m]",
                      Double(tiny));
    prm.add_parameter("Top", p.top,
                      "Direction 'x y z' in which the top face of a shell from a file points on average. Pressure acts "
                      "along it, and plies are stacked towards it. Empty: +z. Where the mean normal has no z component "
                      "(a cosine up to 0.01), it is +y, and without a y component +x. [-]",
                      Anything());
    prm.add_parameter("Material boxes", p.material_boxes,
                      "Material ids of the cells whose centre lies in a box: 'xmin ymin zmin xmax ymax zmax: 1; ...'. "
                      "Other cells keep their ids, which are 0 in built-in parts. See Section 1. [m]",
                      Anything());
    prm.add_parameter("Material patches", p.material_patches,
                      "Material ids of patches of a built-in part: 's0 s1 c0 c1: 1; ...', e.g. '0 1 0 0.1: 1' for a "
                      "sheath. The bounds are shares of the span (0 root, 1 tip) and of the chord (0 leading edge, 1 "
                      "trailing edge). Lines of nodes follow the borders, so that each patch keeps its size on any "
                      "mesh. Material boxes are applied after the patches. [-]",
                      Anything());
    declare_profile(prm, p.profile);
    declare_row(prm, p.row);
    prm.leave_subsection();
  }

  void ThicknessParameters::declare(dealii::ParameterHandler &prm)
  {
    ThicknessParameters &p = *this;
    prm.enter_subsection("Thickness");
    prm.add_parameter("Value", p.value,
                      "Thickness of the blade: a number or a formula in x, y, z on the mid-surface. [m]", Anything());
    prm.add_parameter("By material", p.by_material,
                      "Thickness of the cells with a material id or name: '1: 0.004; root_block: 0.006'. It replaces "
                      "Value. Built-in parts have the id 0. [m]",
                      Anything());
    prm.add_parameter(
      "Table", p.table,
      "File with the thickness of a shell at its nodes, which replaces Value. Its rows are 'x y z thickness' in m, or "
      "'node thickness' with the node's id in the mesh file. A relative path is read like that of Mesh/File. [-]",
      FileName());
    prm.add_parameter(
      "Maximum", p.maximum,
      "Largest thickness of the section: a formula in the normalised span s (0 root, 1 tip). It replaces Value by a "
      "profile along the chord: a parabola on either side of the largest thickness. On a shell from a file, s is the "
      "distance from the root over the sum of the distances from root and tip. Reports name the edge that is its "
      "leading edge. Empty: Value applies. [m]",
      Anything());
    prm.add_parameter(
      "Leading edge", p.leading_edge,
      "Ratio of the thickness at the leading edge to Maximum: a formula in s with values from 0 to 1. [-]", Anything());
    prm.add_parameter(
      "Trailing edge", p.trailing_edge,
      "Ratio of the thickness at the trailing edge to Maximum: a formula in s with values from 0 to 1. [-]",
      Anything());
    prm.add_parameter("Maximum station", p.maximum_station,
                      "Position of the largest thickness, as a share of the chord from the leading edge. [-]",
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
    require(!result.front(), "Mesh/Row/Rigid: the blade in Mesh/Row/Place cannot be rigid, because reports of root and "
                             "tip are about it.\nLeave it out, or set Place to a deformable blade.");
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
    require(row.pitch != 0., "Mesh/Row/Pitch: the blades coincide.\nGive the angle from one to the next.");
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
