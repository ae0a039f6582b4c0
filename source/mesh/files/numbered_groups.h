#pragma once

#include "mesh/files/imported_mesh.h"

#include <birdstrike/core/errors.h>

#include <map>

namespace birdstrike
{
  /// Groups of elements of one dimension by their numbers, as Gmsh, UCD and VTK have them.
  class NumberedGroups
  {
  public:
    NumberedGroups(ImportedMesh &mesh, const std::string &path) : mesh(mesh), path(path)
    {
    }

    /// Begun where it is new. Throws InputError for numbers that cannot be ids.
    ImportedMesh::Group &operator()(const unsigned int dim, const ImportedMesh::Id number)
    {
      if (number < 0 || number > ImportedMesh::largest_number)
        throw InputError("Blade/Mesh/File: '" + path + "': a group has the number " + std::to_string(number) +
                         ".\nAllowed: from 0 to " + std::to_string(ImportedMesh::largest_number) + ".");
      const auto [found, is_new] = places.try_emplace({dim, number}, mesh.groups.size());
      if (is_new)
        {
          auto &group           = mesh.groups.emplace_back();
          group.material_number = group.boundary_number = static_cast<unsigned int>(number);
          group.dim                                     = dim;
        }
      return mesh.groups[found->second];
    }

    bool has(const unsigned int dim, const ImportedMesh::Id number) const
    {
      return places.contains({dim, number});
    }

  private:
    ImportedMesh                                                    &mesh;
    std::string                                                      path;
    std::map<std::pair<unsigned int, ImportedMesh::Id>, std::size_t> places;
  };
} // namespace birdstrike
