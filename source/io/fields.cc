#include <birdstrike/core/fields.h>
#include <birdstrike/io/fields.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    void require_fitting_arrays(const FieldSnapshot &snapshot)
    {
      const auto        fail       = [](const std::string &what) { throw std::logic_error("FieldSnapshot: " + what); };
      const std::size_t n_points   = snapshot.points.size() / 3;
      const std::size_t n_vertices = std::size_t(1) << snapshot.dim;
      if (snapshot.dim != 0 && snapshot.dim != 2 && snapshot.dim != 3)
        fail("cells of dimension " + std::to_string(snapshot.dim));
      if (snapshot.points.size() % 3 != 0 || (snapshot.dim > 0 && snapshot.cells.size() % n_vertices != 0))
        fail("broken rows of points or cells");
      for (const std::uint32_t vertex : snapshot.cells)
        if (vertex >= n_points)
          fail("a cell names point " + std::to_string(vertex) + " of " + std::to_string(n_points));
      const std::size_t n_cells = snapshot.dim == 0 ? n_points : snapshot.cells.size() / n_vertices;
      for (const Field &field : snapshot.fields)
        if (field.values.size() != (field.on_cells ? n_cells : n_points) * field.n_components)
          fail("field '" + field.name + "' has " + std::to_string(field.values.size()) + " values");
    }

    /// A snapshot as deal.II's output classes want it: one patch for each cell (or particle).
    template <int dim>
    class SnapshotWriter : public dealii::DataOutInterface<dim, 3>
    {
    public:
      SnapshotWriter(const FieldSnapshot &snapshot, const double time) : snapshot(snapshot)
      {
        dealii::DataOutBase::VtkFlags flags;
        flags.time                = time;
        flags.print_date_and_time = false;
        flags.compression_level   = dealii::DataOutBase::VtkFlags::best_speed;
        for (const Field &field : snapshot.fields)
          flags.physical_units[field.name] = field.unit;
        this->set_flags(flags);
        make_patches();
      }

    private:
      using Patch = dealii::DataOutBase::Patch<dim, 3>;
      using Range = std::tuple<unsigned int, unsigned int, std::string,
                               dealii::DataComponentInterpretation::DataComponentInterpretation>;

      const FieldSnapshot &snapshot;
      std::vector<Patch>   patches;

      static constexpr unsigned int n_vertices = 1 << dim;

      void make_patches()
      {
        const std::size_t n_cells = dim == 0 ? snapshot.points.size() / 3 : snapshot.cells.size() / n_vertices;
        patches.resize(n_cells);
        const unsigned int n_rows = get_dataset_names().size();
        for (std::size_t cell = 0; cell < n_cells; ++cell)
          {
            Patch &patch      = patches[cell];
            patch.patch_index = cell;
            // its default is "invalid", for which VTU files get neither offsets nor cell types
            if constexpr (dim > 0)
              patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
            patch.data.reinit(n_rows, n_vertices);
            for (unsigned int v = 0; v < n_vertices; ++v)
              {
                const std::size_t point = dim == 0 ? cell : snapshot.cells[cell * n_vertices + v];
                for (unsigned int d = 0; d < 3; ++d)
                  patch.vertices[v][d] = snapshot.points[3 * point + d];
                fill_column(patch, v, cell, point);
              }
          }
      }

      void fill_column(Patch &patch, const unsigned int v, const std::size_t cell, const std::size_t point) const
      {
        unsigned int row = 0;
        for (const Field &field : snapshot.fields)
          for (unsigned int c = 0; c < field.n_components; ++c)
            patch.data(row++, v) = field.values[(field.on_cells ? cell : point) * field.n_components + c];
      }

      const std::vector<Patch> &get_patches() const override
      {
        return patches;
      }

      std::vector<std::string> get_dataset_names() const override
      {
        std::vector<std::string> names;
        for (const Field &field : snapshot.fields)
          for (unsigned int c = 0; c < field.n_components; ++c)
            names.push_back(field.n_components == 1 ? field.name : field.name + "_" + std::to_string(c));
        return names;
      }

      std::vector<Range> get_nonscalar_data_ranges() const override
      {
        std::vector<Range> ranges;
        unsigned int       row = 0;
        for (const Field &field : snapshot.fields)
          {
            if (field.n_components == 3)
              ranges.emplace_back(row, row + 2, field.name,
                                  dealii::DataComponentInterpretation::component_is_part_of_vector);
            row += field.n_components;
          }
        return ranges;
      }
    };

    template <int dim>
    void write_vtu(const FieldSnapshot &snapshot, const double time, std::ostream &out)
    {
      SnapshotWriter<dim>(snapshot, time).write_vtu(out);
    }
  } // namespace

  FieldSeries::FieldSeries(const fs::path &folder, const std::string &name) : folder(folder), name(name)
  {
    fs::create_directories(folder / "fields");
  }

  void FieldSeries::write(const FieldSnapshot &snapshot, const double time)
  {
    require_fitting_arrays(snapshot);
    char number[16];
    std::snprintf(number, sizeof(number), "%04zu", times_and_names.size());
    const std::string file = "fields/" + name + "_" + number + ".vtu";
    std::ofstream     out(folder / file, std::ios::binary);
    if (!out)
      throw std::runtime_error("Cannot write " + (folder / file).string());
    if (snapshot.dim == 0)
      write_vtu<0>(snapshot, time, out);
    else if (snapshot.dim == 2)
      write_vtu<2>(snapshot, time, out);
    else
      write_vtu<3>(snapshot, time, out);
    times_and_names.emplace_back(time, file);
    std::ofstream list(folder / (name + ".pvd"));
    dealii::DataOutBase::write_pvd_record(list, times_and_names);
    out.flush();
    list.flush();
    if (!out || !list)
      throw std::runtime_error("Cannot write " + (folder / file).string() + ": is the disk full?");
    bytes += fs::file_size(folder / file);
  }

  std::size_t FieldSeries::n_files() const
  {
    return times_and_names.size();
  }

  std::size_t FieldSeries::n_bytes() const
  {
    return bytes;
  }

  std::size_t compute_field_file_bytes(const FieldSnapshot &snapshot)
  {
    const std::size_t n_vertices = std::size_t(1) << snapshot.dim;
    const std::size_t n_entries  = snapshot.dim == 0 ? snapshot.points.size() / 3 : snapshot.cells.size();
    std::size_t       n_values   = 3; // the position
    for (const Field &field : snapshot.fields)
      n_values += field.n_components;
    const std::size_t n_cells = n_entries / n_vertices;
    return n_entries * (n_values * sizeof(float) + sizeof(std::int32_t)) + n_cells * (sizeof(std::int32_t) + 1);
  }
} // namespace birdstrike
