#include "mesh/files/imported_mesh.h"
#include <birdstrike/core/errors.h>

#include <algorithm>

namespace birdstrike
{
  std::vector<std::string> ImportedMesh::Group::all_names() const
  {
    std::vector<std::string> names;
    if (!name.empty())
      names.push_back(name);
    names.insert(names.end(), other_names.begin(), other_names.end());
    return names;
  }

  ImportedMesh::NotOffered ImportedMesh::not_offered(const Id id, const std::size_t line, const std::string &what,
                                                     const std::string &remedy)
  {
    const Reason reason{what, remedy};
    const auto   found = std::find(reasons.begin(), reasons.end(), reason);
    const auto   place = static_cast<std::uint32_t>(found - reasons.begin());
    if (found == reasons.end())
      reasons.push_back(reason);
    return {id, line, place};
  }

  void refuse_mesh_file(const std::string &path, const std::string &what, const std::string &remedy)
  {
    throw InputError("Blade/Mesh/File: '" + path + "': " + what + ".\n" + remedy);
  }
} // namespace birdstrike
