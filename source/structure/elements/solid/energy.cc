#include "structure/elements/solid/group.h"

// What bricks store, from their stresses (StoredEnergy).
namespace birdstrike
{
  namespace
  {
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
    state.volume *= batches[b].owned;
    if (erosion)
      state.volume *= erosion->batches[b].alive;
    return state;
  }
} // namespace birdstrike
