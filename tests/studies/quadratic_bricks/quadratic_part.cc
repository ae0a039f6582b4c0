#include "part.h"
#include "quadratic_brick.h"

#include "structure/elements/solid/law.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/simd/records.h>

#include <algorithm>
#include <cstring>

namespace birdstrike::studies
{
  namespace
  {
    using Four = double __attribute__((vector_size(32)));

    /// Bricks in batches of a register's lanes, one thread; forces are added to the nodes in the order of the elements.
    template <auto &in_plane, auto &across>
    class QuadraticPart : public Part
    {
    public:
      using Brick = QuadraticBrick<Lanes, in_plane, across>;

      QuadraticPart(const std::vector<Point3> &points, const std::vector<std::vector<std::uint32_t>> &cells,
                    const Metal &metal, const double stabilisation)
        : cells(cells)
        , metal(metal)
        , stabilisation(stabilisation)
        , law(make_section(metal))
        , records(points.size())
        , node_force(points.size() + 1) // the last one takes what copies of the last element write
      {
        nodes      = points;
        degree     = 2;
        n_elements = cells.size();
        SolidPoint<Lanes> point{};
        for (Lanes &s : point.stress)
          s = 0.;
        point.plastic_strain = point.plastic_work = 0.;
        point.yield                               = law.initial_yield();
        const std::size_t n_batches               = (n_elements + n_lanes - 1) / n_lanes;
        this->points.assign(n_batches * Brick::n_points, point);
        batches.resize(n_batches);
        for (Batch &batch : batches)
          for (auto &q : batch.hourglass)
            q = Vector3<Lanes>::Constant(Lanes(0.));
        for (std::size_t e = 0; e < n_batches * n_lanes; ++e)
          for (int i = 0; i < 27; ++i)
            {
              Batch              &batch    = batches[e / n_lanes];
              const std::uint32_t node     = cells[std::min(e, n_elements - 1)][i];
              batch.record[i][e % n_lanes] = 8 * node;
              batch.node[i][e % n_lanes]   = e < n_elements ? node : static_cast<std::uint32_t>(points.size());
            }
        lump_mass();
        if (stabilisation > 0.)
          set_stiffness();
      }

      void compute_internal_forces(const double *position, const double *increment, const double dt,
                                   double *force) override
      {
        for (std::size_t n = 0; n < nodes.size(); ++n)
          {
            std::memcpy(records[n].value, position + 3 * n, 3 * sizeof(double));
            std::memcpy(records[n].value + 3, increment + 3 * n, 3 * sizeof(double));
            std::memset(node_force[n].value, 0, sizeof node_force[n].value);
          }
        for (std::size_t b = 0; b < batches.size(); ++b)
          update_batch(b, dt);
        for (std::size_t n = 0; n < nodes.size(); ++n)
          std::memcpy(force + 3 * n, node_force[n].value, 3 * sizeof(double));
      }

      double plastic_work() const override
      {
        return dissipated;
      }

      std::unique_ptr<Part> make_elastic(const double *position) const override
      {
        std::vector<Point3> moved;
        for (std::size_t n = 0; n < nodes.size(); ++n)
          moved.emplace_back(position[3 * n], position[3 * n + 1], position[3 * n + 2]);
        Metal elastic         = metal;
        elastic.hardening.law = HardeningLaw::elastic;
        auto part             = std::make_unique<QuadraticPart>(moved, cells, elastic, stabilisation);
        part->grid            = grid;
        part->n_grid          = n_grid;
        part->mass            = mass;
        return part;
      }

    private:
      struct Batch
      {
        std::uint32_t  record[27][n_lanes], node[27][n_lanes];
        double         stiffness[n_lanes]{}; ///< of the stabilisation, N/m
        Vector3<Lanes> hourglass[3];         ///< what it has stretched, m
      };
      struct alignas(32) Force
      {
        double value[4];
      };

      static SolidSection make_section(const Metal &metal)
      {
        SolidSection section;
        section.material         = metal;
        section.linear_viscosity = section.quadratic_viscosity = 0.;
        return section;
      }

      /// Gauss-Lobatto points at the nodes: a diagonal mass matrix (Fried & Malkus 1975).
      void lump_mass()
      {
        mass.assign(3 * nodes.size(), 0.);
        const auto &rule = lobatto_3;
        for (const auto &cell : cells)
          for (int i = 0; i < 27; ++i)
            {
              const int a = i % 3, b = i / 3 % 3, c = i / 9;
              Point3    d[3] = {Point3::Zero(), Point3::Zero(), Point3::Zero()};
              for (int k = 0; k < 3; ++k)
                {
                  d[0] += rule.slope[a][k] * nodes[cell[k + 3 * b + 9 * c]];
                  d[1] += rule.slope[b][k] * nodes[cell[a + 3 * k + 9 * c]];
                  d[2] += rule.slope[c][k] * nodes[cell[a + 3 * b + 9 * k]];
                }
              const double volume = rule.weight[a] * rule.weight[b] * rule.weight[c] * d[0].cross(d[1]).dot(d[2]);
              for (int k = 0; k < 3; ++k)
                mass[3 * cell[i] + k] += metal.density * volume;
            }
      }

      /// A share of the shear energy G/2 int |grad f|^2 of f = (xi^2 - 1/3)(eta^2 - 1/3), of which the springs see 4.
      void set_stiffness()
      {
        for (std::size_t e = 0; e < n_elements; ++e)
          {
            const auto  &cell = cells[e];
            const double a = (nodes[cell[2]] - nodes[cell[0]]).norm(), b = (nodes[cell[6]] - nodes[cell[0]]).norm();
            const double h = (nodes[cell[18]] - nodes[cell[0]]).norm();
            batches[e / n_lanes].stiffness[e % n_lanes] =
              stabilisation * metal.elasticity.shear_modulus() * (8. / 3. * 8. / 45.) / 16. * (a / b + b / a) * h;
          }
      }

      // without `flatten` GCC leaves vector operations of Eigen as calls with their operands in memory
      [[gnu::flatten]] void update_batch(const std::size_t b, const double dt)
      {
        Batch                &batch = batches[b];
        typename Brick::Nodes x, u, force;
        for (int i = 0; i < 27; ++i)
          {
            const auto a = load_rows(records[0].value, batch.record[i]);
            x[i] << a[0], a[1], a[2];
            u[i] << a[3], a[4], a[5];
            force[i] = Vector3<Lanes>::Constant(Lanes(0.));
          }
        SolidPoint<Lanes> *const point    = points.data() + b * Brick::n_points;
        Lanes                    plastic  = 0.;
        const Lanes              smallest = Brick::add_forces(
                       x, u,
                       [&](const Matrix3<Lanes> &gradient, const int q, const Lanes &volume) __attribute__((always_inline)) {
                         plastic += volume * law.update_point(gradient, dt, point[q]);
                         return point[q].stress;
                       },
                       force);
        if (!all(smallest > Lanes(0.)))
          throw NumericalFailure("A quadratic brick is turned inside out.");
        if (stabilisation > 0.)
          Brick::add_stabilisation(u, load<Lanes>(batch.stiffness), batch.hourglass, force);
        add_to_nodes(batch, force);
        const std::size_t n = std::min(n_lanes, n_elements - b * n_lanes);
        for (std::size_t k = 0; k < n; ++k)
          dissipated += plastic[k];
      }

      [[gnu::always_inline]] void add_to_nodes(const Batch &batch, const typename Brick::Nodes &force)
      {
        const Lanes none = 0.;
        for (int i = 0; i < 27; i += 2)
          {
            const int     next = std::min(i + 1, 26);
            Force         part[2 * n_lanes];
            std::uint32_t first[n_lanes], second[n_lanes];
            for (std::uint32_t k = 0; k < n_lanes; ++k)
              {
                first[k]  = 2 * k;
                second[k] = 2 * k + 1;
              }
            store_half_rows(
              {force[i][0], force[i][1], force[i][2], none, force[next][0], force[next][1], force[next][2], none},
              first, second, part);
            for (std::size_t k = 0; k < n_lanes; ++k)
              {
                add(part[2 * k], node_force[batch.node[i][k]]);
                if (next > i)
                  add(part[2 * k + 1], node_force[batch.node[next][k]]);
              }
          }
      }
      [[gnu::always_inline]] static void add(const Force &a, Force &sum)
      {
        Four p, s;
        std::memcpy(&p, a.value, sizeof p);
        std::memcpy(&s, sum.value, sizeof s);
        s += p;
        std::memcpy(sum.value, &s, sizeof s);
      }

      std::vector<std::vector<std::uint32_t>> cells;
      Metal                                   metal;
      double                                  stabilisation; ///< share of the shear stiffness
      SolidLaw                                law;
      AlignedVector<Row>                      records; ///< position and increment
      AlignedVector<Force>                    node_force;
      AlignedVector<SolidPoint<Lanes>>        points;
      AlignedVector<Batch>                    batches;
      double                                  dissipated = 0.;
    };
  } // namespace

  std::unique_ptr<Part> make_quadratic_part(const std::string &name, const Plate &plate, const Metal &metal)
  {
    const BrickMesh   mesh(plate, 2);
    const bool        is_bare = name.size() > 5 && name.substr(name.size() - 5) == "-bare";
    const std::string rule    = is_bare ? name.substr(0, name.size() - 5) : name;
    const auto        make    = [&]<auto & in_plane, auto & across>()->std::unique_ptr<Part>
    {
      const double stabilisation = in_plane.n == 2 && !is_bare ? 0.1 : 0.;
      return std::make_unique<QuadraticPart<in_plane, across>>(mesh.nodes, mesh.cells, metal, stabilisation);
    };
    if (rule == "g2")
      return make.template operator()<gauss_2, gauss_2>();
    if (rule == "g3")
      return make.template operator()<gauss_3, gauss_3>();
    if (rule == "gl3")
      return make.template operator()<lobatto_3, lobatto_3>();
    if (rule == "g2xg3")
      return make.template operator()<gauss_2, gauss_3>();
    if (rule == "g2xg5")
      return make.template operator()<gauss_2, gauss_5>();
    throw InputError("No rule is called \"" + rule + "\": g2, g3, gl3, g2xg3, g2xg5, or these with -bare.");
  }
} // namespace birdstrike::studies
