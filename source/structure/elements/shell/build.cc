#include "structure/elements/element_failure.h"
#include "structure/elements/shell/group.h"
#include "structure/elements/shell/plane_points.h"
#include "structure/elements/shell/step_bound.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  ShellGroup::ShellGroup(const ShellSection &section, Place of_group, const std::vector<double> &thickness,
                         const ElementBlocks &blocks)
    : ElementGroup(std::move(of_group), blocks)
    , section(section)
    , n_in_plane(section.formulation == ShellFormulation::fully_integrated ? full_integration::n_points : 1)
    , points(n_in_plane * batches.size())
    , law(section)
    , initial_yield(law.initial_yield())
    , stress(n_in_plane == 1 ? batches.size() : 0, ShellStress<Lanes>())
    , sections(n_in_plane == 1 ? 0 : n_in_plane * batches.size(), SectionStress<Lanes>())
  {
    for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
      for (std::size_t s = 0; s < n_in_plane; ++s)
        {
          const std::size_t     b         = slot / n_lanes;
          SectionStress<Lanes> &state     = n_in_plane == 1 ? stress[b] : sections[n_in_plane * b + s];
          state.thickness[slot % n_lanes] = thickness[element_of(slot)];
        }
    for (std::size_t e = 0; e < n_elements(); ++e)
      check_shape(e, thickness[e]);
    for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
      {
        const double t                                  = thickness[element_of(slot)];
        batches[slot / n_lanes].radius2[slot % n_lanes] = std::max(t * t / 12., geometry(element_of(slot)).area / 8.);
      }
    if (section.laminate)
      build_laminate();
    if (section.can_fail())
      build_erosion();
  }

  void ShellGroup::update_bounds_at_rest()
  {
    update_bounds([this](const std::size_t b) {
      Lanes bound;
      for (std::size_t k = 0; k < n_lanes; ++k)
        bound[k] = eigenvalue_bound(element_of(b * n_lanes + k));
      if (erosion)
        erosion->batches[b].allowed = bound / (section.smallest_step() * section.smallest_step());
      return bound;
    });
  }

  void ShellGroup::check_shape(const std::size_t e, const double thickness)
  {
    const ShellGeometry<double> g        = geometry(e);
    double                      shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        {
          const double *x = place.records[place.cells[e][i]].position, *y = place.records[place.cells[e][j]].position;
          shortest = std::min(shortest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
        }
    if (!(thickness > 0.) || !(g.area > 1e-7 * g.x.m1.squaredNorm()) || !(shortest > 0.))
      throw InputError("Shell " + where(e).text() + ": thickness " + text_of(thickness) + " m, area " +
                       text_of(g.area) + " m^2, shortest distance of two nodes " + text_of(shortest) +
                       " m; all must be positive.");
    if (!(smallest_area(e) > 0.))
      throw InputError("Shell " + where(e).text() +
                       ": not convex, its Jacobian at a point of the full integration is " +
                       text_of(smallest_area(e) / g.area) + " of that at the centre; it must be positive.");
    mass.push_back(section.density() * thickness * g.area);
  }

  void ShellGroup::get_corners(const std::size_t element, Vector3<double> (&x)[4], Vector3<double> (&n)[4]) const
  {
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c)
        {
          x[i][c] = place.records[place.record_of(element, i)].position[c];
          n[i][c] = place.records[place.record_of(element, i)].normal[c];
        }
  }

  ShellGeometry<double> ShellGroup::geometry(const std::size_t element) const
  {
    Vector3<double> x[4], n[4];
    get_corners(element, x, n);
    return ShellGeometry<double>::of_corners(x, n);
  }

  bool ShellGroup::looks_along_normals(const std::size_t element) const
  {
    Vector3<double> x[4], n[4];
    get_corners(element, x, n);
    return looks_along(n, ShellGeometry<double>::of_corners(x, n).e3);
  }

  double ShellGroup::smallest_area(const std::size_t element) const
  {
    const ShellGeometry<double> g = geometry(element);
    if (n_in_plane == 1)
      return g.area;
    return g.area * min(1., full_integration::PlaneGeometry<double>(g, law.elasticity.poisson).smallest_jacobian);
  }

  double ShellGroup::eigenvalue_bound(const std::size_t element) const
  {
    const ShellGeometry<double> g            = geometry(element);
    const double                t            = largest_thickness(element);
    const ShellBatch           &batch        = batches[element / n_lanes];
    const double                inverse_mass = lane(batch.inverse_mass, element % n_lanes),
                 radius2                     = lane(batch.radius2, element % n_lanes);
    if (laminate)
      return laminate_bound(element, g);
    return n_in_plane == 1 ? compute_eigenvalue_bound<false>(g, t, inverse_mass, radius2, law)
                           : compute_eigenvalue_bound<true>(g, t, inverse_mass, radius2, law);
  }

  void ShellGroup::report_failure(const std::size_t b)
  {
    const auto is_sound = [this](const std::size_t element) {
      double sum = lane(batches[element / n_lanes].bound, element % n_lanes);
      for (const auto &corner : batches[element / n_lanes].corner)
        for (const double f : place.corner_force[corner[element % n_lanes]].value)
          sum += f;
      return std::isfinite(sum) && smallest_area(element) > 0. && looks_along_normals(element);
    };
    for (std::size_t k = 0; k < n_elements_of(b); ++k)
      if (const std::size_t e = b * n_lanes + k; !is_failed(e) && !is_sound(e))
        {
          // of a state that is finite only the geometry of the end can be to blame
          if (!can_collapse() || !has_finite_state(e))
            throw make_element_failure("shell", where(e), "area by its worst point",
                                       looks_along_normals(e) ? smallest_area(e) : -std::abs(smallest_area(e)), "m^2",
                                       bool(erosion));
          erosion->batches[b].collapsed |= 1u << k;
        }
    // copies do as the last element, and write nowhere
    for (std::size_t k = n_elements_of(b); erosion && k < n_lanes; ++k)
      erosion->batches[b].collapsed |= (erosion->batches[b].collapsed >> (n_elements_of(b) - 1) & 1u) << k;
  }
} // namespace birdstrike
