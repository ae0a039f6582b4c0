#include "part.h"

#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"
#include <birdstrike/core/errors.h>

#include <cmath>
#include <utility>

namespace birdstrike::studies
{
  BrickMesh::BrickMesh(const Plate &plate, const unsigned int p)
  {
    // across first: the nodes of a cell stand close together
    const auto          n     = plate.n;
    const std::uint32_t row_z = p * n[2] + 1, row_y = p * n[1] + 1;
    const auto          number = [&](const unsigned int i, const unsigned int j, const unsigned int k) {
      return k + row_z * (j + row_y * i);
    };
    for (unsigned int i = 0; i <= p * n[0]; ++i)
      for (unsigned int j = 0; j < row_y; ++j)
        for (unsigned int k = 0; k < row_z; ++k)
          nodes.emplace_back(plate.length * i / (p * n[0]), plate.chord * (double(j) / (p * n[1]) - 0.5),
                             plate.thickness * (double(k) / (p * n[2]) - 0.5));
    for (unsigned int i = 0; i < n[0]; ++i)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int k = 0; k < n[2]; ++k)
          {
            cells.emplace_back();
            for (unsigned int c = 0; c <= p; ++c)
              for (unsigned int b = 0; b <= p; ++b)
                for (unsigned int a = 0; a <= p; ++a)
                  cells.back().push_back(number(p * i + a, p * j + b, p * k + c));
          }
  }

  void set_grid(const Plate &plate, Part &part)
  {
    const bool   is_shell   = part.n_unknowns == 6;
    const double spacing[3] = {plate.length / (part.degree * plate.n[0]), plate.chord / (part.degree * plate.n[1]),
                               is_shell ? 1. : plate.thickness / (part.degree * plate.n[2])};
    for (int c = 0; c < 3; ++c)
      part.n_grid[c] = c == 2 && is_shell ? 1 : part.degree * plate.n[c] + 1;
    for (const Point3 &x : part.nodes)
      part.grid.push_back(
        {static_cast<unsigned int>(std::lround(x[0] / spacing[0])),
         static_cast<unsigned int>(std::lround((x[1] + 0.5 * plate.chord) / spacing[1])),
         is_shell ? 0u : static_cast<unsigned int>(std::lround((x[2] + 0.5 * plate.thickness) / spacing[2]))});
  }

  namespace
  {
    std::vector<Point3> make_points(const double *position, const std::size_t n)
    {
      std::vector<Point3> points;
      for (std::size_t k = 0; k < n; ++k)
        points.emplace_back(position[3 * k], position[3 * k + 1], position[3 * k + 2]);
      return points;
    }

    /// A part of the program's own elements.
    template <class Elements>
    class LinearPart : public Part
    {
    public:
      explicit LinearPart(Elements elements) : elements(std::move(elements))
      {
      }
      void compute_internal_forces(const double *position, const double *increment, const double dt,
                                   double *force) override
      {
        elements.compute_internal_forces(position, increment, dt, force);
      }
      double plastic_work() const override
      {
        return elements.plastic_work();
      }
      double hourglass_energy() const override
      {
        return elements.hourglass_energy();
      }
      double stable_step_bound() const override
      {
        return elements.largest_stable_step();
      }

    protected:
      Elements elements;
    };

    class BrickPart : public LinearPart<SolidElements>
    {
    public:
      using Cells = std::vector<std::array<std::uint32_t, 8>>;

      BrickPart(const std::vector<Point3> &nodes, const Cells &cells, const SolidSection &section, ThreadPool &pool)
        : LinearPart(SolidElements(nodes, cells, section, pool)), cells(cells), section(section), pool(pool)
      {
        this->nodes = nodes;
        n_elements  = cells.size();
        for (const double m : elements.compute_nodal_masses())
          mass.insert(mass.end(), 3, m);
      }
      std::unique_ptr<Part> make_elastic(const double *position) const override
      {
        SolidSection elastic           = section;
        elastic.material.hardening.law = HardeningLaw::elastic;
        auto part    = std::make_unique<BrickPart>(make_points(position, nodes.size()), cells, elastic, pool);
        part->grid   = grid;
        part->n_grid = n_grid;
        part->mass   = mass;
        return part;
      }

    private:
      Cells        cells;
      SolidSection section;
      ThreadPool  &pool;
    };

    class ShellPart : public LinearPart<ShellElements>
    {
    public:
      using Cells = std::vector<std::array<std::uint32_t, 4>>;

      ShellPart(const std::vector<Point3> &nodes, const Cells &cells, const double thickness,
                const ShellSection &section, ThreadPool &pool)
        : LinearPart(ShellElements(nodes, cells, std::vector<double>(cells.size(), thickness), section, pool))
        , cells(cells)
        , thickness(thickness)
        , section(section)
        , pool(pool)
      {
        this->nodes                       = nodes;
        n_elements                        = cells.size();
        n_unknowns                        = 6;
        const std::vector<double> masses  = elements.compute_nodal_masses();
        const std::vector<double> inertia = elements.compute_rotary_inertias();
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            mass.insert(mass.end(), 3, masses[k]);
            mass.insert(mass.end(), 3, inertia[k]);
          }
      }
      std::unique_ptr<Part> make_elastic(const double *position) const override
      {
        ShellSection elastic           = section;
        elastic.material.hardening.law = HardeningLaw::elastic;
        auto part  = std::make_unique<ShellPart>(make_points(position, nodes.size()), cells, thickness, elastic, pool);
        part->grid = grid;
        part->n_grid = n_grid;
        part->mass   = mass;
        return part;
      }

    private:
      Cells        cells;
      double       thickness;
      ShellSection section;
      ThreadPool  &pool;
    };

    std::unique_ptr<Part> make_shell(const Plate &plate, const Metal &metal, ThreadPool &pool)
    {
      const auto [n_span, n_chord, n_layers] = plate.n;
      std::vector<Point3> nodes;
      for (unsigned int j = 0; j <= n_chord; ++j)
        for (unsigned int i = 0; i <= n_span; ++i)
          nodes.emplace_back(plate.length * i / n_span, plate.chord * (double(j) / n_chord - 0.5), 0.);
      ShellPart::Cells cells;
      for (unsigned int j = 0; j < n_chord; ++j)
        for (unsigned int i = 0; i < n_span; ++i)
          {
            const std::uint32_t a = i + (n_span + 1) * j, b = a + n_span + 1;
            cells.push_back({a, a + 1, b + 1, b});
          }
      ShellSection section;
      section.material = metal;
      return std::make_unique<ShellPart>(nodes, cells, plate.thickness, section, pool);
    }

    std::unique_ptr<Part> make_bricks(const Plate &plate, const Metal &metal, const SolidFormulation formulation,
                                      ThreadPool &pool)
    {
      const BrickMesh  mesh(plate, 1);
      BrickPart::Cells cells(mesh.cells.size());
      for (std::size_t e = 0; e < cells.size(); ++e)
        std::copy(mesh.cells[e].begin(), mesh.cells[e].end(), cells[e].begin());
      SolidSection section;
      section.formulation      = formulation;
      section.material         = metal;
      section.linear_viscosity = section.quadratic_viscosity = 0.;
      return std::make_unique<BrickPart>(mesh.nodes, cells, section, pool);
    }
  } // namespace

  std::unique_ptr<Part> make_part(const std::string &kind, const Plate &plate, const Metal &metal, ThreadPool &pool)
  {
    std::unique_ptr<Part> part;
    if (kind == "shell")
      part = make_shell(plate, metal, pool);
    else if (kind == "one-point")
      part = make_bricks(plate, metal, SolidFormulation::one_point, pool);
    else if (kind == "b-bar")
      part = make_bricks(plate, metal, SolidFormulation::b_bar, pool);
    else if (kind.rfind("quadratic-", 0) == 0)
      part = make_quadratic_part(kind.substr(10), plate, metal);
    else
      throw InputError("No element is called \"" + kind + "\": shell, one-point, b-bar, or quadratic-RULE.");
    set_grid(plate, *part);
    return part;
  }
} // namespace birdstrike::studies
