#include "io/symmetry_check.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/thickness_law.h>

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

    constexpr const char *mirrored_values = "the same at y and -y (a y component: with the other sign)";

    bool is_same(const double a, const double b)
    {
      return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
    }

    /// Where the blade evaluates formulas, on the half that is computed: nodes, centroids and points of integration.
    /// The mesh is made when it is first asked for.
    class Places
    {
    public:
      explicit Places(const BladeParameters &blade) : blade(blade)
      {
      }

      const std::vector<Point3> &get()
      {
        if (points.empty())
          (blade.kind == BladeKind::solid && blade.mesh.generator == MeshGenerator::file) ? add_solid() : add_surface();
        return points;
      }

    private:
      const BladeParameters &blade;
      std::vector<Point3>    points;

      void add_surface()
      {
        MeshParameters surface = blade.mesh;
        surface.material_boxes.clear(); // of layers, which a surface does not have
        const ShellMesh mesh({surface, {}, true});
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
          points.push_back(mesh.node(n));
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
          {
            const Point3 middle = mesh.centroid(cell);
            points.push_back(middle);
            for (const std::uint32_t n : mesh.cells[cell])
              points.push_back(middle + (mesh.node(n) - middle) / std::sqrt(3.));
          }
      }

      void add_solid()
      {
        const SolidMesh mesh(blade);
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
          points.push_back(mesh.node(n));
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
          points.push_back(mesh.centroid(cell));
      }
    };

    /// Whether each component of a formula is even (+1) or odd (-1) in y, wherever and whenever the blade asks it.
    void require_parity(const std::string &text, const std::vector<int> &parity, const std::string &entry,
                        const double end_time, Places &places)
    {
      if (!is_present(text))
        return;
      const Expression expression(text, parity.size(), entry);
      bool             is_symmetric = true;
      for (const Point3 &p : places.get())
        for (const double t : {0., 1e-3 * end_time, 0.03 * end_time, 0.4 * end_time, end_time})
          for (unsigned int c = 0; c < parity.size(); ++c)
            {
              const double there[3] = {p[0], -p[1], p[2]};
              is_symmetric =
                is_symmetric && is_same(expression.value(p.data(), t, c), parity[c] * expression.value(there, t, c));
            }
      refuse_unless(is_symmetric, "Blade/" + entry, mirrored_values);
    }

    void require_symmetric_thickness(const BladeParameters &blade, Places &places)
    {
      if (blade.mesh.generator == MeshGenerator::file)
        refuse_unless(blade.thickness.maximum.empty(), "Blade/Thickness/Maximum",
                      "nothing, on half a mesh from a file");
      const ThicknessLaw law          = make_thickness_law(blade);
      bool               is_symmetric = true;
      for (const Point3 &p : places.get())
        {
          const double there[3] = {p[0], -p[1], p[2]};
          is_symmetric          = is_symmetric && is_same(law({p.data()}), law({there}));
        }
      if (blade.thickness.maximum.empty())
        refuse_unless(is_symmetric, "Blade/Thickness/Value", mirrored_values);
      else
        refuse_unless(is_symmetric, "Blade/Thickness/Maximum station, with Leading edge and Trailing edge,",
                      "0.5, and both edges alike");
      for (const auto &[section, of_section] : blade.by_section())
        if (section > 0)
          require_parity(blade.sections[section - 1].thickness, {1}, blade.section_path(section) + "Thickness", 0.,
                         places);
    }

    void require_symmetric_bird(const BirdParameters &bird)
    {
      const auto  &v     = bird.velocity;
      const double speed = std::hypot(v[0], v[1], v[2]);
      refuse_unless(v[1] == 0., bird.section + "/Velocity", "a y component of 0");
      refuse_unless(bird.aim_point[1] == 0., bird.section + "/Aim point", "y = 0");
      refuse_unless(bird.chordwise_offset == 0., bird.section + "/Chordwise offset", "0");
      // along the span, yaw turns about y and pitch about z; elsewhere yaw turns out of the plane
      const bool flies_along_span = std::abs(v[0]) > 0.999999 * speed && speed > 0.;
      refuse_unless((flies_along_span ? bird.pitch : bird.yaw) == 0.,
                    bird.section + (flies_along_span ? "/Pitch" : "/Yaw"), "0: the bird's axis lies in the plane");
      refuse_unless(bird.roll == 0., bird.section + "/Roll", "0: the lattice is its own mirror image");
      refuse_unless(!bird.is_lattice_shifted(), bird.section + "/Lattice shift",
                    "0, 0: the lattice is its own mirror image");
      refuse_unless(!bird.is_periodic[1], bird.section + "/Periodic directions", "none, x, z");
    }

    void require_both_edges(const std::string &ids, const std::string &entry)
    {
      constexpr unsigned int leading = 2, trailing = 3; // boundaries of the flat plate
      const auto             list = built_in_boundaries().parse(ids, "Blade/" + entry);
      const auto has = [&](const unsigned int id) { return std::find(list.begin(), list.end(), id) != list.end(); };
      refuse_unless(has(leading) == has(trailing), "Blade/" + entry, "both edges (2 and 3) or neither");
    }

    void require_symmetric_supports(const BladeParameters &blade)
    {
      const BladeParameters::Supports &supports = blade.supports;
      if (blade.mesh.generator != MeshGenerator::file) // of a file the other half has the boundaries of this one
        {
          if (supports.clamped != supports.automatic) // the root
            require_both_edges(supports.clamped, "Supports/Clamped");
          require_both_edges(supports.hub, "Supports/Hub");
          for (const auto &[key, motion] : parse_pairs(supports.driven, "Blade/Supports/Driven"))
            require_both_edges(key, "Supports/Driven");
        }
      refuse_unless(supports.held.empty(), "Blade/Supports/Held", "nothing, with a symmetry plane");
      refuse_unless(supports.held_boxes.empty(), "Blade/Supports/Held boxes", "nothing, with a symmetry plane");
    }

    void require_symmetric_blade(const BladeParameters &blade, const double end_time)
    {
      if (blade.kind == BladeKind::rigid)
        refuse_unless(blade.rigid.centre[1] == 0. && blade.rigid.normal[1] == 0., "Blade/Rigid/Centre or Normal",
                      "a y component of 0");
      if (!blade.is_deformable())
        return;
      refuse_unless(blade.mesh.generator != MeshGenerator::flat_plate ||
                      (blade.mesh.chord_grading == 1. && blade.mesh.n_chord % 2 == 0),
                    "Blade/Mesh", "an even number of equal elements along the chord");
      Places places(blade);
      require_symmetric_thickness(blade, places);
      require_parity(blade.loads.pressure, {1}, "Loads/Pressure", end_time, places);
      require_parity(blade.loads.initial_velocity, {1, -1, 1}, "Loads/Initial velocity", 0., places);
      // a spin is an axial vector
      require_parity(blade.loads.initial_spin, {-1, 1, -1}, "Loads/Initial spin", 0., places);
      if (blade.kind == BladeKind::solid && blade.mesh.generator != MeshGenerator::file &&
          is_present(blade.loads.pressure))
        require_both_edges(blade.loads.pressure_boundaries, "Loads/Pressure boundaries");
      refuse_unless(blade.loads.point_loads.empty(), "Blade/Loads/Point loads", "nothing, with a symmetry plane");
      require_symmetric_supports(blade);
    }

    void require_visible(const CaseParameters &parameters)
    {
      for (const auto &[name, where] : parse_pairs(parameters.blade.probes, "Blade/Probes"))
        refuse_unless(parse_numbers(where, 3, "Blade/Probes")[1] >= 0., "Blade/Probes: '" + name + "'",
                      "y >= 0, the half that is computed");
      for (const PressurePatch &patch : parameters.contact.pressure_patches())
        refuse_unless(patch.centre[1] == 0. || patch.centre[1] >= patch.radius,
                      "Contact/Pressure patches: '" + patch.name + "'",
                      "a centre at y = 0, or a disc that lies in y >= 0");
    }
  } // namespace

  void require_symmetry(const CaseParameters &parameters)
  {
    for (const BirdCase &each : parameters.birds())
      require_symmetric_bird(each.bird);
    require_symmetric_blade(parameters.blade, parameters.time.end_time);
    require_visible(parameters);
  }
} // namespace birdstrike
