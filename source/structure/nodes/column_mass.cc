#include <birdstrike/core/simd/registers.h>

#include "structure/nodes/column_mass.h"

#include <algorithm>
#include <functional>

namespace birdstrike
{
  namespace
  {
    [[gnu::always_inline]] inline Four read_node(const double *entries)
    {
      // by components: half a register written and the whole read again would wait for the stores
      const Four f = {entries[0], entries[1], entries[2], 0.};
      return f;
    }

    template <class Vector>
    std::size_t bytes_of(const Vector &v)
    {
      return v.capacity() * sizeof(typename Vector::value_type);
    }
  } // namespace

  ColumnMass::ColumnMass(const NodeColumns &columns, std::vector<double> given_coupling, const double *inverse_mass,
                         const std::size_t n_owned, ThreadPool &pool)
    : pool(pool)
    , n_owned(n_owned)
    , nodes(columns.nodes)
    , begin(columns.begin)
    , coupling(std::move(given_coupling))
    , factors(nodes.size(), Factor{})
    , work(nodes.size())
  {
    for (std::size_t p = 0; p < nodes.size(); ++p)
      std::copy_n(inverse_mass + 3 * std::size_t(nodes[p]), 3, factors[p].inverse_mass);
    for (std::size_t c = 0; c + 1 < begin.size(); ++c)
      coupling[begin[c + 1] - 1] = 0.;
    for (std::size_t c = 0; c + 1 < begin.size(); ++c)
      for (std::size_t p = begin[c]; p + 1 < begin[c + 1]; ++p)
        for (unsigned int d = 0; d < 3 && coupling[p] > 0.; ++d)
          {
            const double mobility  = factors[p].inverse_mass[d];
            const bool   has_below = p > begin[c] && coupling[p - 1] > 0.;
            const double lower     = has_below ? -mobility * factors[p - 1].inverse_pivot[d] : 0.;
            const double pivot =
              1. / coupling[p] + mobility + factors[p + 1].inverse_mass[d] + lower * (has_below ? mobility : 0.);
            factors[p].lower[d]         = lower;
            factors[p].inverse_pivot[d] = 1. / pivot;
          }
  }

  void ColumnMass::compute_effective_forces(const double *force, const double *external, double *effective)
  {
    const auto body = [&](const std::size_t first, const std::size_t last) {
      for (std::size_t c = first; c < last; ++c)
        if (external)
          compute_column(c, force, effective, [external](const std::size_t i) { return read_node(external + i); });
        else
          compute_column(c, force, effective, [](std::size_t) { return Four{}; });
    };
    pool.parallel_for(begin.size() - 1, columns_per_chunk, std::cref(body));
  }

  template <class External>
  [[gnu::always_inline]] inline void ColumnMass::compute_column(const std::size_t c, const double *force,
                                                                double *effective, const External &external)
  {
    const std::size_t bottom = begin[c], top = begin[c + 1] - 1;
    Four              f, y{}, lower, inverse_mass, inverse_pivot;
    const auto        read_free_acceleration = [&](const std::size_t p) {
      const std::size_t i = 3 * std::size_t(nodes[p]);
      f                   = read_node(force + i);
      read(factors[p].inverse_mass, inverse_mass);
      write(f, work[p].force);
      return Four((f + external(i)) * inverse_mass);
    };
    Four below = read_free_acceleration(bottom);
    for (std::size_t p = bottom; p < top; ++p)
      {
        const Four above = read_free_acceleration(p + 1);
        read(factors[p].lower, lower);
        y = above - below - lower * y;
        write(y, work[p].right);
        below = above;
      }
    Four       carried{}, carried_above{};
    const auto write_force = [&](const std::size_t p) {
      read(work[p].force, f);
      f += carried_above - carried;
      std::memcpy(effective + 3 * std::size_t(nodes[p]), &f, 3 * sizeof(double));
    };
    for (std::size_t p = top; p-- > bottom;)
      {
        read(factors[p].inverse_pivot, inverse_pivot);
        read(factors[p + 1].lower, lower);
        read(work[p].right, y);
        carried_above = carried;
        carried       = y * inverse_pivot - lower * carried_above;
        write_force(p + 1);
      }
    carried_above = carried;
    carried       = Four{};
    write_force(bottom);
  }

  std::array<double, 3> ColumnMass::angular_momentum(const double *position, const double *velocity) const
  {
    return pool.ordered_sums<3>(coupling.size(), [&](const std::size_t first, const std::size_t last) {
      std::array<double, 3> sums{};
      for (std::size_t p = first; p < last; ++p)
        if (is_booked(p))
          {
            const std::size_t i = 3 * std::size_t(nodes[p]), j = 3 * std::size_t(nodes[p + 1]);
            const Point3      x = Point3(position + j) - Point3(position + i);
            const Point3      v = Point3(velocity + j) - Point3(velocity + i);
            const Point3      h = coupling[p] * x.cross(v);
            for (unsigned int d = 0; d < 3; ++d)
              sums[d] += h[d];
          }
      return sums;
    });
  }

  std::size_t ColumnMass::bytes() const
  {
    return bytes_of(nodes) + bytes_of(begin) + bytes_of(coupling) + bytes_of(factors) + bytes_of(work);
  }
} // namespace birdstrike
