#include "mesh/generated_surface.h"
#include "mesh/mesh_file.h"
#include "mesh/solid_mesh_grid.h"

#include <birdstrike/mesh/thickness_law.h>

#include <utility>

namespace birdstrike
{
  namespace
  {
    /// Corners of a face in lexicographic order, counter-clockwise about the outward normal of the cell.
    constexpr unsigned int outward[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  } // namespace

  VolumeMesh SolidMesh::Grid::extract() const
  {
    VolumeMesh mesh;
    for (const auto &vertex : triangulation.get_vertices())
      mesh.nodes.push_back({{vertex[0], vertex[1], vertex[2]}});
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        std::array<std::uint32_t, 8> nodes;
        for (const unsigned int v : cell->vertex_indices())
          nodes[v] = cell->vertex_index(v);
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            mesh.faces.push_back(
              {static_cast<std::uint32_t>(mesh.cells.size()),
               f,
               {{nodes[outward[f][0]], nodes[outward[f][1]], nodes[outward[f][2]], nodes[outward[f][3]]}},
               cell->face(f)->boundary_id()});
        mesh.cells.push_back(nodes);
        mesh.material_ids.push_back(cell->material_id());
      }
    return mesh;
  }

  SolidMesh::SolidMesh(const GeometryParameters &parameters) : grid(std::make_unique<Grid>())
  {
    const MeshParameters &mesh         = parameters.mesh;
    const bool            is_generated = mesh.generator != "file";
    if (is_generated)
      {
        const ThicknessLaw law       = make_thickness_law(parameters);
        const auto         thickness = [&law](const Point3 &p) { return thickness_at(law, p.data(), 0); };
        make_solid(generate_surface(mesh, parameters.is_halved), layer_heights(mesh.n_layers, mesh.layer_grading),
                   thickness, grid->triangulation);
      }
    else
      read_mesh_file(mesh, grid->triangulation);

    plain = grid->extract();
    check_shape(plain);
    make_skin(plain, parameters.is_halved);
    if (is_generated)
      {
        plain.layers = mesh.n_layers;
        if (parameters.is_halved)
          plain.mirrored_ids = {2};
      }
  }

  SolidMesh::~SolidMesh() = default;

  const VolumeMesh &SolidMesh::volume() const
  {
    return plain;
  }
} // namespace birdstrike
