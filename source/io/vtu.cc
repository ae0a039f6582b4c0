#include "io/vtu.h"
#include <birdstrike/core/fields.h>
#include <birdstrike/io/fields.h>

#include <deal.II/base/utilities.h>

#include <array>
#include <cstring>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <zlib.h>

namespace birdstrike
{
  namespace
  {
    std::size_t n_points_of(const FieldSnapshot &snapshot)
    {
      return snapshot.points.size() / 3;
    }

    std::size_t n_cells_of(const FieldSnapshot &snapshot)
    {
      return snapshot.dim == 0 ? n_points_of(snapshot) : snapshot.cells.size() >> snapshot.dim;
    }

    void require_fitting_arrays(const FieldSnapshot &snapshot)
    {
      const auto        fail       = [](const std::string &what) { throw std::logic_error("FieldSnapshot: " + what); };
      const std::size_t n_points   = n_points_of(snapshot);
      const std::size_t n_vertices = std::size_t(1) << snapshot.dim;
      if (snapshot.dim != 0 && snapshot.dim != 2 && snapshot.dim != 3)
        fail("cells of dimension " + std::to_string(snapshot.dim));
      if (snapshot.points.size() % 3 != 0 || (snapshot.dim > 0 && snapshot.cells.size() % n_vertices != 0))
        fail("broken rows of points or cells");
      for (const std::uint32_t vertex : snapshot.cells)
        if (vertex >= n_points)
          fail("a cell names point " + std::to_string(vertex) + " of " + std::to_string(n_points));
      for (const Field &field : snapshot.fields)
        if (field.values.size() != (field.on_cells ? n_cells_of(snapshot) : n_points) * field.n_components)
          fail("field '" + field.name + "' has " + std::to_string(field.values.size()) + " values");
    }

    /// One zlib stream in base64 behind VTK's header: blocks, block size, size of the last block, compressed size. An
    /// array without values has no block, and its header ends there.
    template <class T>
    std::string encode(const std::vector<T> &values)
    {
      const auto n_bytes = static_cast<uLong>(values.size() * sizeof(T));
      if (n_bytes > std::numeric_limits<std::uint32_t>::max())
        throw std::runtime_error("A field of more than 4 GiB does not fit into a VTU file: write fewer cells.");
      if (values.empty())
        return dealii::Utilities::encode_base64(std::vector<unsigned char>(3 * sizeof(std::uint32_t)));
      uLongf                     n_left = compressBound(n_bytes);
      std::vector<unsigned char> body(n_left);
      if (compress2(body.data(), &n_left, reinterpret_cast<const Bytef *>(values.data()), n_bytes, Z_BEST_SPEED) !=
          Z_OK)
        throw std::runtime_error("zlib cannot compress the fields: is the memory exhausted?");
      body.resize(n_left);
      const std::array<std::uint32_t, 4> sizes{1, std::uint32_t(n_bytes), std::uint32_t(n_bytes),
                                               std::uint32_t(n_left)};
      std::vector<unsigned char>         header(sizeof(sizes));
      std::memcpy(header.data(), sizes.data(), sizeof(sizes));
      return dealii::Utilities::encode_base64(header) + dealii::Utilities::encode_base64(body);
    }

    constexpr const char *type_name(float)
    {
      return "Float32";
    }
    constexpr const char *type_name(std::int32_t)
    {
      return "Int32";
    }
    constexpr const char *type_name(std::uint8_t)
    {
      return "UInt8";
    }

    template <class T>
    void write_array(std::ostream &out, const std::string &attributes, const std::vector<T> &values)
    {
      out << "<DataArray type=\"" << type_name(T()) << "\" format=\"binary\"" << attributes << ">\n"
          << encode(values) << "\n</DataArray>\n";
    }

    std::string attribute(const std::string &name, const std::string &value)
    {
      return " " + name + "=\"" + value + "\"";
    }

    /// VTK goes round a quadrilateral, and round the bottom and the top of a hexahedron.
    void write_cells(const FieldSnapshot &snapshot, std::ostream &out)
    {
      static constexpr unsigned int round[8]   = {0, 1, 3, 2, 4, 5, 7, 6};
      const std::size_t             n_vertices = std::size_t(1) << snapshot.dim, n_cells = n_cells_of(snapshot);
      std::vector<std::int32_t>     connectivity(n_cells * n_vertices), offsets(n_cells);
      for (std::size_t cell = 0; cell < n_cells; ++cell)
        {
          for (std::size_t v = 0; v < n_vertices; ++v)
            connectivity[cell * n_vertices + v] =
              static_cast<std::int32_t>(snapshot.dim == 0 ? cell : snapshot.cells[cell * n_vertices + round[v]]);
          offsets[cell] = static_cast<std::int32_t>((cell + 1) * n_vertices);
        }
      constexpr std::uint8_t vtk_vertex = 1, vtk_quad = 9, vtk_hexahedron = 12;
      out << "<Cells>\n";
      write_array(out, attribute("Name", "connectivity"), connectivity);
      write_array(out, attribute("Name", "offsets"), offsets);
      write_array(out, attribute("Name", "types"),
                  std::vector<std::uint8_t>(n_cells, snapshot.dim == 0   ? vtk_vertex
                                                     : snapshot.dim == 2 ? vtk_quad
                                                                         : vtk_hexahedron));
      out << "</Cells>\n";
    }

    void write_field(const Field &field, std::ostream &out)
    {
      const std::string attributes = attribute("Name", field.name) +
                                     attribute("NumberOfComponents", std::to_string(field.n_components)) +
                                     attribute("units", field.unit);
      if (field.is_number)
        return write_array(out, attributes, std::vector<std::int32_t>(field.values.begin(), field.values.end()));
      write_array(out, attributes, std::vector<float>(field.values.begin(), field.values.end()));
    }

    void write_fields(const FieldSnapshot &snapshot, const bool on_cells, std::ostream &out)
    {
      const char *tag = on_cells ? "CellData" : "PointData";
      out << '<' << tag << ">\n";
      for (const Field &field : snapshot.fields)
        if (field.on_cells == on_cells)
          write_field(field, out);
      out << "</" << tag << ">\n";
    }
  } // namespace

  void write_vtu(const FieldSnapshot &snapshot, const double time, std::ostream &out)
  {
    require_fitting_arrays(snapshot);
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
           "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
        << time << "</DataArray>\n";
    if (snapshot.is_deformed) // a viewer that warps does not warp twice
      out << "<DataArray type=\"UInt8\" Name=\"deformed\" NumberOfTuples=\"1\" format=\"ascii\">1</DataArray>\n";
    out << "</FieldData>\n<Piece" << attribute("NumberOfPoints", std::to_string(n_points_of(snapshot)))
        << attribute("NumberOfCells", std::to_string(n_cells_of(snapshot))) << ">\n<Points>\n";
    write_array(out, attribute("NumberOfComponents", "3"),
                std::vector<float>(snapshot.points.begin(), snapshot.points.end()));
    out << "</Points>\n";
    write_cells(snapshot, out);
    for (const bool on_cells : {false, true})
      write_fields(snapshot, on_cells, out);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  std::size_t compute_field_file_bytes(const FieldSnapshot &snapshot)
  {
    const std::size_t n_vertices = std::size_t(1) << snapshot.dim;
    std::size_t       n_bytes    = n_points_of(snapshot) * 3 * sizeof(float) +
                          n_cells_of(snapshot) * ((n_vertices + 1) * sizeof(std::int32_t) + sizeof(std::uint8_t));
    for (const Field &field : snapshot.fields)
      n_bytes += (field.on_cells ? n_cells_of(snapshot) : n_points_of(snapshot)) * field.n_components * sizeof(float);
    return n_bytes;
  }
} // namespace birdstrike
