#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/material/metal.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike::studies
{
  /// A flat plate, x along the span from the clamped root, y along the chord, centred, z through the thickness (m).
  struct Plate
  {
    double                      length = 0.3112, chord = 0.0889, thickness = 4.27e-3;
    std::array<unsigned int, 3> n{{14, 4, 1}}; ///< elements
  };

  /// What the study asks of each kind of element: forces, masses, stable step, and the grid that its nodes form.
  class Part
  {
  public:
    virtual ~Part() = default;

    /// position [n][3] at the end (m), increment [n][n_unknowns] since the last call, force [n][n_unknowns] of the
    /// elements on the nodes: overwritten.
    virtual void compute_internal_forces(const double *position, const double *increment, double dt, double *force) = 0;
    virtual double plastic_work() const                                                                             = 0;
    virtual double hourglass_energy() const
    {
      return 0.;
    }
    /// The element's own bound (s), 0 where it has none.
    virtual double stable_step_bound() const
    {
      return 0.;
    }
    /// The same part, elastic and free of stress, with nodes at other places.
    virtual std::unique_ptr<Part> make_elastic(const double *position) const = 0;

    std::vector<Point3>                      nodes; ///< m
    std::vector<std::array<unsigned int, 3>> grid;  ///< place of each node in the grid
    std::array<unsigned int, 3>              n_grid{};
    unsigned int                             degree     = 1;
    unsigned int                             n_unknowns = 3;
    std::size_t                              n_elements = 0;
    std::vector<double>                      mass; ///< [n][n_unknowns], kg and kg m^2
  };

  /// shell, one-point, b-bar, or quadratic-RULE: g2, g3, gl3 (Gauss, Gauss-Lobatto, all ways), g2xg3, g2xg5 (in plane
  /// x across). Two points in the plane are stabilised by a tenth of the shear stiffness that they miss; not so with
  /// "-bare" at the end. Bricks have no bulk viscosity here. Throws InputError for any other name.
  std::unique_ptr<Part> make_part(const std::string &kind, const Plate &plate, const Metal &metal, ThreadPool &pool);
  std::unique_ptr<Part> make_quadratic_part(const std::string &name, const Plate &plate, const Metal &metal);

  /// Nodes of the plate in bricks of a degree, those of deal.II's FE_Q, and of each cell in lexicographic order.
  struct BrickMesh
  {
    BrickMesh(const Plate &plate, unsigned int degree);

    std::vector<Point3>                     nodes;
    std::vector<std::vector<std::uint32_t>> cells;
  };
  /// Where the nodes stand in the grid that they form.
  void set_grid(const Plate &plate, Part &part);
} // namespace birdstrike::studies
