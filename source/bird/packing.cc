#include "bird/attitude.h"
#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    /// Lattice of unit particle volume: points of the cubic or fcc lattice whose origin is shifted by a symmetric
    /// offset.
    struct Lattice
    {
      double              cell;  ///< edge of the cubic cell
      double              layer; ///< between layers across an axis, in cells
      std::vector<Point3> basis; ///< in cells
    };

    Lattice make_lattice(const BirdLattice packing)
    {
      if (packing == BirdLattice::fcc) // four particles a cell
        return {std::cbrt(4.), 0.5, {{0., 0., 0.}, {.5, .5, 0.}, {.5, 0., .5}, {0., .5, .5}}};
      return {1., 1., {{0., 0., 0.}}};
    }

    /// Points cells * (n + basis + shift) inside the shape; cells: edges, m.
    std::vector<Point3> cut_lattice(const Lattice &lattice, const Shape &shape, const Point3 &cells,
                                    const Point3 &shift)
    {
      const Point3        h = shape.half_lengths().cwiseQuotient(cells);
      std::vector<Point3> points;
      const auto          first = [&](const int d) { return static_cast<int>(std::floor(-h[d])) - 2; };
      for (int k = first(2); k <= -first(2); ++k)
        for (int j = first(1); j <= -first(1); ++j)
          for (int i = first(0); i <= -first(0); ++i)
            for (const Point3 &b : lattice.basis)
              {
                const Point3 p = cells.cwiseProduct(Point3(i, j, k) + b + shift);
                if (shape.contains(p))
                  points.push_back(p);
              }
      return points;
    }

    /// Edges of the cells, m, and the shifts along the axis, in cells, that keep the lattice symmetric: through a
    /// layer, or between two.
    struct Cells
    {
      Point3              edges;
      std::vector<double> shifts;
    };

    /// Between flat ends the whole number of layers that is nearest to the spacing fills the length; across it cells
    /// have what leaves a particle its volume.
    Cells fit_cells(const Lattice &lattice, const Shape &shape, const double spacing)
    {
      const double cell = lattice.cell * spacing, between = 0.5 * lattice.layer;
      if (!shape.has_flat_ends())
        return {Point3::Constant(cell), {0., between}};
      const double n     = std::max(1., std::round(shape.length() / (lattice.layer * cell)));
      const double along = shape.length() / (n * lattice.layer), across = cell * std::sqrt(cell / along);
      return {Point3(across, across, along), {std::fmod(n, 2.) == 1. ? 0. : between}};
    }

    /// Of the shifts that keep the lattice symmetric about the axis keeps the cut whose count is nearest to the volume;
    /// that lattice is then moved across the axis as the entry says.
    std::vector<Point3> pack(const BirdParameters &parameters, const Shape &shape, const Lattice &lattice,
                             const Cells &cells)
    {
      const double        wanted = shape.volume() / std::pow(parameters.spacing, 3);
      std::vector<Point3> best;
      Point3              of_best = Point3::Zero();
      for (const double lateral : {0., 0.5 * lattice.layer})
        if (!parameters.is_halved || lateral > 0.) // no particle in the plane of symmetry
          for (const double axial : cells.shifts)
            {
              const Point3        shift(lateral, lateral, axial);
              std::vector<Point3> points = cut_lattice(lattice, shape, cells.edges, shift);
              if (best.empty() || std::abs(points.size() - wanted) < std::abs(best.size() - wanted))
                {
                  best    = std::move(points);
                  of_best = shift;
                }
            }
      if (!parameters.is_lattice_shifted())
        return best;
      const auto &[x, y] = parameters.lattice_shift;
      return cut_lattice(lattice, shape, cells.edges, of_best + Point3(x, y, 0.));
    }

    /// A slab takes whole numbers of cells along each length.
    std::array<double, 3> count_cells(const Shape &shape, const double cell)
    {
      std::array<double, 3> n;
      for (int d = 0; d < 3; ++d)
        n[d] = std::max(1., std::round(2. * shape.half_lengths()[d] / cell));
      return n;
    }

    std::vector<Point3> pack_slab(const BirdParameters &parameters, const Shape &shape, const Lattice &lattice)
    {
      const double        a = lattice.cell * parameters.spacing;
      const auto          n = count_cells(shape, a);
      std::vector<Point3> points;
      const double        inset = lattice.basis.size() == 1 ? 0.5 : 0.25;
      for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
          for (int i = 0; i < n[0]; ++i)
            for (const Point3 &b : lattice.basis)
              points.push_back(a * (Point3(i, j, k) + b + Point3::Constant(inset) - 0.5 * Point3(n[0], n[1], n[2])));
      return points;
    }

    Point3 compute_start(const BirdParameters &parameters, const double bounding_radius)
    {
      const Point3 v(parameters.velocity.data()), target(parameters.target().data());
      if (parameters.shape == BirdShape::slab || v.norm() == 0.)
        return target;
      const double distance = parameters.stand_off > 0. ? parameters.stand_off : 2. * bounding_radius;
      return target - distance * v.normalized();
    }

    /// Before anything is packed; of the whole bird nothing.
    void check_slice(const BirdParameters &parameters, const Shape &shape)
    {
      if (!shape.is_slice())
        return;
      const auto refuse = [&](const std::string &found, const std::string &action) {
        throw InputError(fmt::format("Section '{}', entry 'Slice/Between': {}\n{}", parameters.section, found, action));
      };
      if (shape.length() == 0.)
        refuse(fmt::format("nothing of the bird lies between {:.4g} and {:.4g} m.", parameters.slice_between[0],
                           parameters.slice_between[1]),
               fmt::format("Along this normal it reaches from {0:.4g} to {1:.4g} m.", -shape.reach_along_normal(),
                           shape.reach_along_normal()));
      if (shape.length() < 2. * parameters.spacing)
        refuse(fmt::format("the slice is {:.4g} m thick, less than two particle spacings.", shape.length()),
               fmt::format("Give a thicker one, or a {}/Particle spacing of at most {:.4g} m.", parameters.section,
                           0.5 * shape.length()));
      if (shape.volume() < 8. * std::pow(parameters.spacing, 3))
        refuse("the slice holds fewer than about eight particles.",
               fmt::format("Give a larger one, or a {}/Particle spacing below {:.4g} m.", parameters.section,
                           0.5 * std::cbrt(shape.volume())));
    }

    void check_period(const double period, const double range, const std::string &section)
    {
      if (period < 2. * range)
        throw InputError(fmt::format("Section '{}', entry 'Periodic directions': the period {:.4g} m is shorter than "
                                     "two interaction ranges ({:.4g} m).\nA particle would meet its own image twice: "
                                     "make the body at least six particle spacings wide there.",
                                     section, period, 2. * range));
    }
  } // namespace

  double count_particles(const BirdParameters &parameters)
  {
    const Shape shape(parameters);
    if (!shape.is_slab())
      return shape.volume() / std::pow(parameters.spacing, 3);
    const Lattice lattice = make_lattice(parameters.packing);
    const auto    n       = count_cells(shape, lattice.cell * parameters.spacing);
    return n[0] * n[1] * n[2] * static_cast<double>(lattice.basis.size());
  }

  Packing compute_packing(const BirdParameters &parameters, const Shape &shape)
  {
    check_slice(parameters, shape);
    const Lattice lattice = make_lattice(parameters.packing);
    const Cells   cells   = fit_cells(lattice, shape, parameters.spacing);
    Packing       packing;
    packing.points = shape.is_slab() ? pack_slab(parameters, shape, lattice) : pack(parameters, shape, lattice, cells);
    if (packing.points.empty())
      throw InputError("Section '" + parameters.section +
                       "': the shape holds no particle.\nChoose a smaller 'Particle spacing'.");

    const std::size_t n = packing.points.size();
    const double      m = shape.volume() * parameters.density;
    // what the count is off scales the lattice, across the axis alone where layers fill the length
    const double ratio    = std::cbrt(shape.volume() / n) / parameters.spacing;
    packing.particle_mass = m / n;
    packing.spacing       = parameters.spacing * ratio;
    const double along = shape.has_flat_ends() ? 1. : ratio, across = std::sqrt(ratio / along) * ratio;
    double       low = INFINITY, high = -INFINITY;
    for (Point3 &p : packing.points)
      {
        p                       = p.cwiseProduct(Point3(across, across, along));
        low                     = std::min(low, p[2]);
        high                    = std::max(high, p[2]);
        p                       = shape.in_bird(p);
        packing.bounding_radius = std::max(packing.bounding_radius, p.norm());
      }
    packing.length = high - low + lattice.layer * cells.edges[2] * along;
    packing.bounding_radius += packing.spacing;
    // A cross-section is as large as its share of the volume: D scales with the cut's count at fixed shape.
    packing.diameter = shape.diameter() * std::sqrt(shape.length() / packing.length);

    const Matrix3<double> attitude = shape.is_slab() ? Matrix3<double>::Identity() : compute_attitude(parameters);
    packing.axis                   = attitude.col(2);
    packing.centre                 = compute_start(parameters, packing.bounding_radius);
    const double range             = 2. * parameters.smoothing_ratio * packing.spacing * (1. + parameters.skin);
    for (int d = 0; d < 3; ++d)
      if (parameters.is_periodic[d])
        {
          const double a       = parameters.packing == BirdLattice::fcc ? std::cbrt(4.) : 1.;
          const double nominal = shape.is_slab() ? 2. * shape.half_lengths()[d] : packing.length;
          const double cell    = a * packing.spacing;
          packing.period[d] =
            shape.is_slab() ? std::max(1., std::round(nominal / (a * parameters.spacing))) * cell : nominal;
          check_period(packing.period[d], range, parameters.section);
          if (!shape.is_slab() && std::abs(packing.axis[d]) < 1. - 1e-12)
            throw InputError("Section '" + parameters.section +
                             "', entry 'Periodic directions': a cylinder repeats itself along its axis "
                             "only.\nLet the velocity point along that direction, without yaw or pitch.");
        }
    for (Point3 &p : packing.points)
      p = packing.centre + attitude * p;
    if (parameters.is_halved)
      {
        packing.plane = SymmetryPlane(true);
        std::erase_if(packing.points, [](const Point3 &p) { return p[1] < 0.; });
        if (2 * packing.points.size() != n)
          throw InputError("Section '" + parameters.section +
                           "': the packing is not symmetric about y = 0.\nCompute the whole bird.");
      }
    return packing;
  }

  std::string Packing::summary(const Shape &shape) const
  {
    return fmt::format("{}: {} particles{} of {:.6g} g, spacing {:.5g} mm, mass {:.9g} kg; {} {:.5g} mm (nominal "
                       "{:.5g}), diameter {:.5g} mm (nominal {:.5g})",
                       shape.is_slice() ? "slice of the bird" : "bird", points.size(),
                       plane.exists() ? " and their mirror images" : "", 1e3 * particle_mass, 1e3 * spacing, mass(),
                       shape.is_slice() ? "thickness" : "length", 1e3 * length, 1e3 * shape.length(), 1e3 * diameter,
                       1e3 * shape.diameter());
  }
} // namespace birdstrike
