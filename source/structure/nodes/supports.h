#pragma once

#include <birdstrike/core/expression.h>
#include <birdstrike/core/warning.h>
#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Which unknowns of owned nodes are held at zero velocity: by boundary id or name (clamped, hub, named components),
  /// by coordinate boxes, and on a plane of symmetry; and which are driven, their displacement a formula of time. A
  /// node of a shell has six unknowns, one of a solid three: "clamped" holds all of them. Throws InputError for a
  /// boundary id or name that the mesh does not have, a box without nodes, an unknown component, single rotations of a
  /// solid, a formula that cannot be read, is not 0 at t = 0, or drives across a plane of symmetry.
  struct Supports
  {
    /// `turns`: with the hub, and what is held follows it; then only whole nodes can be. Of a row, `is_rigid` says
    /// which blades are held as a whole.
    Supports(const BladeParameters::Supports &parameters, const SurfaceMesh &mesh, bool turns = false,
             const std::vector<bool> &is_rigid = {});
    Supports(const BladeParameters::Supports &parameters, const VolumeMesh &mesh, bool turns = false,
             const std::vector<bool> &is_rigid = {});

    struct Driven
    {
      std::vector<std::uint32_t>     dofs;         ///< sorted
      std::shared_ptr<const TimeLaw> displacement; ///< m or rad

      double at(const double time) const
      {
        return (*displacement)(time);
      }
    };

    std::vector<std::uint32_t> held_dofs; ///< sorted, n_unknowns node + component, driven ones among them
    std::vector<Driven>        driven;
    std::vector<unsigned int>  clamped_ids; ///< clamped and hub
    std::vector<unsigned int>  root_ids;    ///< hub if given, else clamped
    std::vector<unsigned int>  tip_ids;     ///< those of the tip list that the mesh has
    /// Of Held and Held boxes, as text, that hold ux uy uz of all nodes of a face of a solid, without being called
    /// clamped: they hold its rotation too.
    std::vector<std::string> held_faces;
    Warnings                 warnings; ///< nodes of named sets that stay free; a boundary that is held all round

  private:
    template <class Mesh>
    void find_roles(const BladeParameters::Supports &parameters, const Mesh &mesh);
    template <unsigned int n_unknowns, class Mesh>
    void find_held(const BladeParameters::Supports &parameters, const Mesh &mesh, bool turns,
                   const std::vector<bool> &is_rigid);
    template <class Mesh>
    void warn_of_whole_rim(const Mesh &mesh);
    template <unsigned int n_unknowns, class Mesh>
    void warn_of_nodes_off_sides(const BladeParameters::Supports &parameters, const Mesh &mesh);
  };
} // namespace birdstrike
