#include "mesh/blade_grid.h"
#include "mesh/check_cells.h"
#include "mesh/generated_surface.h"
#include "mesh/material_boxes.h"
#include "mesh/mesh_file.h"
#include "mesh/seams/check_seams.h"

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/orientation.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace birdstrike
{
  namespace
  {
    MeshLabels generate(const GeometryParameters &p, dealii::Triangulation<2, 3> &triangulation)
    {
      make_shell(generate_surface(p.mesh, p.is_halved), p.mesh.row, triangulation);
      return {built_in_boundaries()};
    }

    MeshLabels generate(const GeometryParameters &p, dealii::Triangulation<3> &triangulation)
    {
      const ThicknessLaw law       = make_thickness_law(p);
      const auto         thickness = [&law](const Point3 &x) { return thickness_at(law, {x.data()}); };
      make_solid(generate_surface(p.mesh, p.is_halved), layer_heights(p.mesh.n_layers, p.mesh.layer_grading), thickness,
                 p.mesh.row, triangulation);
      return {built_in_boundaries()};
    }

    /// Facets across edges. Each edge has two facets, or one where the plane of symmetry cuts the skin open (in a part
    /// of a mesh also where the other is not here). `line(facet, side)`: deal.II's index of an edge.
    template <class Line>
    void join_facets(SurfaceMesh &skin, const std::size_t n_lines, const Line &line)
    {
      constexpr std::uint32_t                   none = -1;
      std::vector<std::array<std::uint32_t, 2>> first(n_lines, {{none, 0}});
      skin.neighbors.assign(skin.cells.size(), {{-1, -1, -1, -1}});
      for (std::uint32_t facet = 0; facet < skin.cells.size(); ++facet)
        for (std::uint32_t side = 0; side < 4; ++side)
          {
            auto &[other, other_side] = first[line(facet, side)];
            if (other == none)
              {
                other      = facet;
                other_side = side;
                continue;
              }
            if (skin.neighbors[other][other_side] >= 0)
              refuse_edge(skin.centroid(facet));
            skin.neighbors[other][other_side] = static_cast<std::int32_t>(facet);
            skin.neighbors[facet][side]       = static_cast<std::int32_t>(other);
          }
    }

    void make_skin(VolumeMesh &mesh, const std::vector<dealii::DoFHandler<3>::active_cell_iterator> &cells,
                   const std::size_t n_lines)
    {
      SurfaceMesh &skin = mesh.skin;
      skin              = SurfaceMesh();
      skin.space        = mesh.space;
      skin.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + static_cast<std::ptrdiff_t>(mesh.n_skin_nodes));
      for (const auto &face : mesh.boundary)
        {
          skin.cells.push_back(face.nodes);
          skin.material_ids.push_back(mesh.material_ids[face.cell]);
          if (!mesh.blades.empty())
            skin.blades.push_back(mesh.blades[face.cell]);
          skin.n_owned_cells += skin.is_owned(skin.cells.size() - 1);
        }
      join_facets(skin, n_lines, [&](const std::size_t facet, const unsigned int side) {
        const auto &face   = mesh.boundary[facet];
        const auto &nodes  = mesh.cells[face.cell];
        const auto  corner = [&](const unsigned int k) {
          return static_cast<unsigned int>(std::find(nodes.begin(), nodes.end(), face.nodes[k % 4]) - nodes.begin());
        };
        const auto [a, b] = std::minmax({corner(side), corner(side + 1)});
        unsigned int line = 0;
        while (dealii::GeometryInfo<3>::line_to_cell_vertices(line, 0) != a ||
               dealii::GeometryInfo<3>::line_to_cell_vertices(line, 1) != b)
          ++line;
        return cells[face.cell]->line_index(line);
      });
      const auto is_on_plane = [&mesh](const std::uint32_t n) {
        return std::binary_search(mesh.symmetry_nodes.begin(), mesh.symmetry_nodes.end(), n);
      };
      std::ranges::copy_if(mesh.symmetry_nodes, std::back_inserter(skin.symmetry_nodes),
                           [&](const std::uint32_t n) { return n < mesh.n_skin_nodes; });
      for (std::size_t facet = 0; facet < skin.cells.size(); ++facet)
        for (unsigned int side = 0; side < 4; ++side)
          if (const auto [a, b] = skin.side_nodes(facet, side);
              skin.neighbors[facet][side] < 0 && is_on_plane(a) && is_on_plane(b))
            skin.neighbors[facet][side] = FacetsView::symmetry_edge;
    }
  } // namespace

  template <int dim>
  BladeMesh<dim>::BladeMesh(const GeometryParameters &parameters) : grid(std::make_shared<Grid>())
  {
    const MeshParameters &mesh         = parameters.mesh;
    const bool            is_generated = mesh.generator != MeshGenerator::file;
    grid->labels = is_generated ? generate(parameters, grid->triangulation) : read_mesh_file(mesh, grid->triangulation);
    grid->row    = mesh.row;
    grid->is_halved = parameters.is_halved;
    set_material_ids(mesh.material_boxes, parameters.is_halved, grid->triangulation,
                     [this](const unsigned int cell, const Point3 &x) { return grid->as_first(cell, x); });
    if (grid->is_halved)
      put_on_symmetry_plane(grid->triangulation);
    if (is_generated && grid->is_halved)
      this->mirrored_ids = {2};
    check_cells(grid->triangulation);
    if (!is_generated)
      this->open_seams = check_seams(grid->triangulation, grid->labels, mesh.file);
    const std::size_t n_skin_nodes = grid->distribute_dofs();
    if constexpr (dim == 3)
      {
        this->n_skin_nodes = n_skin_nodes;
        this->layers       = is_generated ? mesh.n_layers : 0;
      }
    extract(0, static_cast<std::uint32_t>(grid->dofs.n_dofs() / n_unknowns));
    if constexpr (dim == 2)
      if (!is_generated)
        face_upwards(mesh.top);
  }

  template <int dim>
  void BladeMesh<dim>::extract(const std::uint32_t first, const std::uint32_t last)
  {
    // corners counter-clockwise as deal.II's vertices, and the faces between them; as listed and turned
    static constexpr unsigned int vertices[2][4] = {{0, 1, 3, 2}, {0, 2, 3, 1}},
                                  faces[2][4]    = {{2, 1, 3, 0}, {0, 3, 1, 2}};
    this->space                                  = grid->make_space(first, last);
    this->nodes.resize(this->space.size());
    this->file_node_ids.resize(grid->labels.node_ids.empty() ? 0 : this->nodes.size());
    std::vector<std::int32_t>                number(grid->triangulation.n_active_cells(), FacetsView::free_edge);
    std::vector<typename Grid::CellIterator> here;
    for (const auto &cell : grid->dofs.active_cell_iterators())
      if (Grid::is_here(this->space, cell))
        {
          number[cell->active_cell_index()] = static_cast<std::int32_t>(here.size());
          here.push_back(cell);
        }
    this->n_owned_cells = 0;
    this->cells.resize(here.size());
    this->neighbors.resize(here.size());
    for (std::uint32_t n = 0; n < here.size(); ++n)
      {
        const auto &cell      = here[n];
        const bool  is_turned = dim == 2 && cell->direction_flag() == grid->is_turned;
        for (unsigned int k = 0; k < this->n_corners; ++k)
          {
            const unsigned int  v    = dim == 2 ? vertices[is_turned][k % 4] : k;
            const std::uint32_t node = this->space.local(Grid::node(cell, v));
            this->cells[n][k]        = node;
            if (!grid->labels.node_ids.empty())
              this->file_node_ids[node] = grid->labels.node_ids[cell->vertex_index(v)];
            for (unsigned int d = 0; d < 3; ++d)
              this->nodes[node][d] = cell->vertex(v)[d];
          }
        this->n_owned_cells += this->is_owned(n);
        this->material_ids.push_back(cell->material_id());
        if (!grid->labels.element_ids.empty())
          this->file_element_ids.push_back(grid->labels.element_ids[cell->active_cell_index()]);
        if (grid->row.n_blades > 1)
          this->blades.push_back(grid->blade_of(cell->active_cell_index()));
        for (unsigned int f = 0; f < this->n_sides; ++f)
          {
            const unsigned int side =
              dim == 2
                ? static_cast<unsigned int>(std::find(faces[is_turned], faces[is_turned] + 4, f) - faces[is_turned])
                : f;
            const bool is_boundary = cell->at_boundary(f);
            this->neighbors[n][side] =
              is_boundary ? FacetsView::free_edge : number[cell->neighbor(f)->active_cell_index()];
            if (is_boundary)
              this->boundary.push_back({n, side, this->side_nodes(n, side), cell->face(f)->boundary_id()});
          }
      }
    const auto ids = grid->triangulation.get_boundary_ids();
    this->boundary_ids.assign(ids.begin(), ids.end());
    this->boundary_names = grid->labels.boundaries;
    this->material_names = grid->labels.materials;
    this->file_notes     = grid->labels.notes;
    if (this->space.is_whole() && grid->row.n_blades == 1)
      check_connection(*this);
    if (grid->is_halved)
      this->cut_at_symmetry_plane();
    if constexpr (dim == 3)
      {
        if (!this->space.is_whole())
          this->n_skin_nodes = this->space.size();
        make_skin(*this, here, grid->triangulation.n_raw_lines());
      }
  }

  template <int dim>
  void BladeMesh<dim>::face_upwards(const std::string &top)
  {
    if constexpr (dim == 2)
      {
        Point3 sum  = Point3::Zero();
        double area = 0.;
        for (std::size_t cell = 0; cell < this->cells.size(); ++cell)
          {
            sum += this->area_vector(cell);
            area += this->area_vector(cell).norm();
          }
        const std::string entry = "Blade/Mesh/Top";
        if (top.empty())
          grid->is_turned = sum.norm() > 1e-6 * area && sign_by_axes(sum, {{2, 1, 0}}) < 0.;
        else
          {
            const Point3 wanted(parse_numbers(top, 3, entry).data());
            const double cosine = sum.dot(wanted) / (sum.norm() * wanted.norm());
            if (!(std::abs(cosine) > 0.01)) // or not a number
              throw InputError(entry + ": '" + top + "' lies along the surface, whose mean normal is " +
                               point_text(Point3(sum.normalized()).data()) +
                               ".\nGive a direction out of it, or leave it empty.");
            grid->is_turned = cosine < 0.;
          }
        if (grid->is_turned)
          *this = part(0, this->space.size());
      }
  }

  template <int dim>
  BladeMesh<dim> BladeMesh<dim>::part(const std::uint32_t first, const std::uint32_t last) const
  {
    BladeMesh part;
    part.grid         = grid;
    part.mirrored_ids = this->mirrored_ids;
    part.open_seams   = this->open_seams;
    if constexpr (dim == 3)
      {
        part.n_skin_nodes = this->n_skin_nodes;
        part.layers       = this->layers;
      }
    part.extract(first, last);
    return part;
  }

  template <int dim>
  std::optional<std::uint32_t> BladeMesh<dim>::nearest_node(const Point3 &p, const bool only_on_boundary) const
  {
    std::vector<bool> is_asked;
    if (only_on_boundary)
      {
        is_asked.assign(grid->triangulation.n_vertices(), false);
        for (const auto &cell : grid->triangulation.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              for (const unsigned int v : cell->face(f)->vertex_indices())
                is_asked[cell->face(f)->vertex_index(v)] = true;
      }
    const std::uint32_t node = grid->node_of_vertex[dealii::GridTools::find_closest_vertex(
      grid->triangulation, dealii::Point<3>(p[0], p[1], p[2]), is_asked)];
    if (this->space.has(node) && this->space.is_owned(this->space.local(node)))
      return this->space.local(node);
    return {};
  }

  template class BladeMesh<2>;
  template class BladeMesh<3>;
} // namespace birdstrike
