#include "registers.h"

#include <birdstrike/blade/column_mass.h>

#include <functional>

namespace birdstrike
{
  namespace
  {
    [[gnu::always_inline]] inline Four read_node(const double *entries)
    {
      Four f{};
      std::memcpy(&f, entries, 3 * sizeof(double)); // a fourth would be of a node that another thread may write
      return f;
    }

    template <class Vector>
    std::size_t bytes_of(const Vector &v)
    {
      return v.capacity() * sizeof(typename Vector::value_type);
    }
  } // namespace

  ColumnMass::ColumnMass(const NodeColumns &columns, std::vector<double> given_coupling, const double *mass,
                         const double *inverse_mass, ThreadPool &pool)
    : pool(pool)
    , nodes(columns.nodes)
    , begin(columns.begin)
    , coupling(std::move(given_coupling))
    , factors(nodes.size() + 1, Factor{})
    , work(nodes.size())
  {
    for (std::size_t c = 0; c + 1 < begin.size(); ++c)
      for (unsigned int d = 0; d < 3; ++d)
        {
          double before = 0.; // coupling to the place before, if both move
          for (std::size_t p = begin[c]; p < begin[c + 1]; ++p)
            {
              const std::size_t i       = 3 * std::size_t(nodes[p]) + d;
              const bool        is_free = inverse_mass[i] > 0., has_next = p + 1 < begin[c + 1];
              const bool        is_next_free = has_next && inverse_mass[3 * std::size_t(nodes[p + 1]) + d] > 0.;
              const double      below = p > begin[c] ? coupling[p - 1] : 0., above = has_next ? coupling[p] : 0.;
              if (is_free)
                {
                  const double lower          = before > 0. ? -before * factors[p - 1].inverse_pivot[d] : 0.;
                  factors[p].lower[d]         = lower;
                  factors[p].inverse_pivot[d] = 1. / (mass[i] + below + above + lower * before);
                }
              before = is_free && is_next_free ? above : 0.;
            }
        }
  }

  void ColumnMass::compute_effective_forces(const double *force, const double *external, double *effective)
  {
    const auto body = [&](const std::size_t first, const std::size_t last) {
      for (std::size_t c = first; c < last; ++c)
        {
          Four lower, inverse_pivot, y{};
          for (std::size_t p = begin[c]; p < begin[c + 1]; ++p)
            {
              const std::size_t i = 3 * std::size_t(nodes[p]);
              read(factors[p].lower, lower);
              const Four f = external ? read_node(force + i) + read_node(external + i) : read_node(force + i);
              y            = f - lower * y;
              write(y, work[p].value);
            }
          // back, with the impulse rates k_e (a_above - a_below) that the edges carry
          Four a{}, a_above{}, carried_above{};
          for (std::size_t p = begin[c + 1]; p-- > begin[c];)
            {
              const std::size_t i = 3 * std::size_t(nodes[p]);
              read(factors[p].inverse_pivot, inverse_pivot);
              read(factors[p + 1].lower, lower); // zero where the next column begins
              read(work[p].value, y);
              a_above            = a;
              a                  = y * inverse_pivot - lower * a_above;
              const Four carried = coupling[p] * (a_above - a);
              if (p + 1 < begin[c + 1])
                {
                  const std::size_t j = 3 * std::size_t(nodes[p + 1]);
                  const Four        f = read_node(force + j) + carried_above - carried;
                  std::memcpy(effective + j, &f, 3 * sizeof(double));
                }
              carried_above = carried;
              if (p == begin[c])
                {
                  const Four f = read_node(force + i) + carried;
                  std::memcpy(effective + i, &f, 3 * sizeof(double));
                }
            }
        }
    };
    pool.parallel_for(begin.size() - 1, columns_per_chunk, std::cref(body));
  }

  std::array<double, 3> ColumnMass::angular_momentum(const double *position, const double *velocity) const
  {
    return pool.ordered_sums<3>(coupling.size(), [&](const std::size_t first, const std::size_t last) {
      std::array<double, 3> sums{};
      for (std::size_t p = first; p < last; ++p)
        if (coupling[p] > 0.)
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
