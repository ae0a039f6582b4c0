#include "mesh_writers.h"

#include <ostream>

namespace birdstrike::test
{
  bool ListedMesh::is_solid() const
  {
    return cells.front().size() == 8;
  }

  std::set<unsigned int> ListedMesh::nodes_on(const unsigned int id) const
  {
    std::set<unsigned int> on_side;
    for (const Side &side : sides)
      if (side.id == id)
        on_side.insert(side.nodes.begin(), side.nodes.end());
    return on_side;
  }

  namespace
  {
    /// `n` a line.
    void write_list(std::ostream &out, const auto &ids, const unsigned int n)
    {
      unsigned int k = 0;
      for (const unsigned int id : ids)
        {
          out << (k % n == 0 ? "" : ", ") << id;
          ++k;
          out << (k % n == 0 ? "\n" : "");
        }
      out << (k % n == 0 ? "" : "\n");
    }

    void write_nodes(std::ostream &out, const ListedMesh &mesh, const char *separator)
    {
      out.precision(17);
      for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
        out << k + 1 << separator << mesh.nodes[k][0] << separator << mesh.nodes[k][1] << separator << mesh.nodes[k][2]
            << '\n';
    }
  } // namespace

  void write_gmsh(std::ostream &out, const ListedMesh &mesh)
  {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << mesh.names.size() << '\n';
    for (const auto &[id, name] : mesh.names)
      out << (mesh.is_solid() ? 2 : 1) << ' ' << id << " \"" << name << "\"\n";
    out << "$EndPhysicalNames\n$Nodes\n" << mesh.nodes.size() << '\n';
    write_nodes(out, mesh, " ");
    out << "$EndNodes\n$Elements\n" << mesh.cells.size() + mesh.sides.size() << '\n';
    std::size_t n   = 0;
    const auto  add = [&](const unsigned int type, const unsigned int id, const std::vector<unsigned int> &nodes) {
      out << ++n << ' ' << type << " 2 " << id << ' ' << id;
      for (const unsigned int node : nodes)
        out << ' ' << node;
      out << '\n';
    };
    for (const auto &side : mesh.sides)
      add(mesh.is_solid() ? 3 : 1, side.id, side.nodes);
    for (const auto &cell : mesh.cells)
      add(mesh.is_solid() ? 5 : 3, 1, cell);
    out << "$EndElements\n";
  }

  void write_abaqus(std::ostream &out, const ListedMesh &mesh)
  {
    out << "*HEADING\n plate\n*NODE, NSET=all\n";
    write_nodes(out, mesh, ", ");
    out << "*ELEMENT, TYPE=" << (mesh.is_solid() ? "C3D8R" : "S4R") << ", ELSET=blade\n";
    for (std::size_t k = 0; k < mesh.cells.size(); ++k)
      write_list((out << k + 1 << ", "), mesh.cells[k], 8);
    for (const auto &[id, name] : mesh.names)
      write_list((out << "*NSET, NSET=\"" << name << "\"\n"), mesh.nodes_on(id), 8);
    out << "*MATERIAL, NAME=metal\n*ELASTIC\n113.8e9, 0.34\n";
  }

  void write_ls_dyna(std::ostream &out, const ListedMesh &mesh)
  {
    const auto column = [&out](const auto value, const std::size_t width) {
      const std::string text = std::to_string(value);
      out << std::string(width - text.size(), ' ') << text;
    };
    const auto row = [&](const auto &values, const std::size_t width) {
      unsigned int k = 0;
      for (const auto value : values)
        {
          column(value, width);
          out << (++k % 8 == 0 ? "\n" : "");
        }
      out << (k % 8 == 0 ? "" : "\n");
    };
    out << "*KEYWORD\n*TITLE\nplate\n*PART\nblade\n         5         1         1\n*NODE\n";
    write_nodes(out, mesh, ",");
    out << (mesh.is_solid() ? "*ELEMENT_SOLID\n" : "*ELEMENT_SHELL\n");
    for (std::size_t k = 0; k < mesh.cells.size(); ++k)
      {
        column(k + 1, 8);
        column(5, 8);
        row(mesh.cells[k], 8);
      }
    for (const auto &[id, name] : mesh.names)
      {
        out << (mesh.is_solid() ? "*SET_SEGMENT_TITLE\n" : "*SET_NODE_LIST_TITLE\n") << name << '\n';
        row(std::vector{id}, 10);
        if (!mesh.is_solid())
          row(mesh.nodes_on(id), 10);
        else
          for (const auto &side : mesh.sides)
            if (side.id == id)
              row(side.nodes, 10);
      }
    out << "*END\n";
  }
} // namespace birdstrike::test
