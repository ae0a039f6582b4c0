#pragma once

#include "mesh/files/abaqus/keyword_line.h"
#include "mesh/files/abaqus/scopes.h"

namespace birdstrike
{
  /// Parts, their instances and the assembly of an Abaqus file. Each part with its first instance is a group, by the
  /// names of both, that Mesh/Parts may name. What is not offered is kept with a complaint: further parts where all of
  /// the file is wanted, further instances of a part, an instance that is moved.
  class AbaqusParts
  {
  public:
    using Id = ImportedMesh::Id;

    AbaqusParts(ImportedMesh &mesh, FileLines &lines, AbaqusScopes &scopes) : mesh(mesh), lines(lines), scopes(scopes)
    {
    }

    bool        begin(const AbaqusKeyword &keyword); ///< false: it has nothing to do with them
    std::size_t present() const                      ///< scope
    {
      return scope;
    }
    std::size_t instance(const std::string &name) const; ///< its scope; throws InputError where there is none
    void        move_present();
    void        add_element(Id id, unsigned int dim); ///< to the present part
    void        finish();                             ///< names of groups

  private:
    std::size_t add_part(const std::string &name);
    void        begin_instance(const AbaqusKeyword &keyword);
    void        complain(std::size_t of, const std::string &what);

    ImportedMesh                      &mesh;
    FileLines                         &lines;
    AbaqusScopes                      &scopes;
    std::size_t                        scope = 0, assembly = 0;
    std::map<std::size_t, std::size_t> groups; ///< by scope
  };
} // namespace birdstrike
