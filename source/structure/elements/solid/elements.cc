#include "structure/elements/solid/elements.h"
#include "structure/elements/solid/thickness.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::vector<std::uint8_t> find_axes(const std::vector<Point3> &nodes, const std::vector<SolidElements::Cell> &cells,
                                        const Sections<SolidSection> &sections)
    {
      const auto is_solid_shell = [](const SolidSection &s) { return s.formulation == SolidFormulation::solid_shell; };
      std::vector<std::uint8_t> axes(cells.size(), 2);
      if (std::none_of(sections.all.begin(), sections.all.end(), is_solid_shell))
        return axes;
      const auto found = solid_shell::find_thickness(nodes, cells).axis;
      for (std::size_t e = 0; e < cells.size(); ++e)
        if (is_solid_shell(sections.of(e)))
          axes[e] = found[e];
      return axes;
    }

    /// Of the residual stresses of the points, which have neither mean nor moment: what the section stores besides
    /// those (J/m^3).
    Lanes compute_residual_density(const Elasticity &elasticity, const ThicknessPoints &rule,
                                   const AlignedVector<solid_shell::LayerPoint<Lanes>> &points)
    {
      Lanes density = 0.;
      for (unsigned int k = 0; k < rule.n; ++k)
        {
          const auto &r   = points[k].residual; // 11 + 22, 11 - 22, 12, 31, 32
          const Lanes s11 = 0.5 * (r[0] + r[1]), s22 = 0.5 * (r[0] - r[1]);
          density += (0.25 * rule.weight[k] / elasticity.young) *
                     (s11 * s11 + s22 * s22 - 2. * elasticity.poisson * s11 * s22 +
                      2. * (1. + elasticity.poisson) * (r[2] * r[2] + r[3] * r[3] + r[4] * r[4]));
        }
      return density;
    }
  } // namespace

  SolidElements::SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                               const Sections<SolidSection> &sections, ThreadPool &pool)
    : SolidElements(nodes, cells, find_axes(nodes, checked(cells, nodes.size()), sections), sections, pool)
  {
  }

  SolidElements::SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                               const std::vector<std::uint8_t> &axes, const Sections<SolidSection> &sections,
                               ThreadPool &pool)
    : Elements(nodes, solid_shell::with_third(axes, cells), axes, sections, pool)
  {
  }

  // What bricks store, from their stresses and the shape of their corners (StoredEnergy).
  StoredEnergy::State SolidGroup::stored(const std::size_t k) const
  {
    const std::size_t   b = k / n_points();
    StoredEnergy::State state{{compute_elastic_energy(law.elasticity, points[k].stress), Lanes(0.)}, Lanes(0.)};
    if (section.formulation == SolidFormulation::b_bar)
      state.volume = (1. / 512.) * rest_det[k];
    else
      {
        state.volume     = (1. / 64.) * batches[b].rest_det;
        state.density[1] = one_point_solid::compute_energy(law.elasticity, stabilisation[b]);
        if (!layers.empty() && !layers[b].empty())
          state.density[0] += compute_residual_density(law.elasticity, rule, layers[b]);
      }
    if (k % n_points() == 0)
      state.density[1] += batches[b].corner_energy / state.volume;
    state.volume *= batches[b].owned;
    if (erosion)
      state.volume *= erosion->batches[b].alive;
    return state;
  }

  double SolidElements::elastic_energy() const
  {
    return stored_energy()[0];
  }

  double SolidElements::hourglass_energy() const
  {
    return stored_energy()[1];
  }
} // namespace birdstrike
