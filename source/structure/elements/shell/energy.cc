#include "structure/elements/shell/batch.h"

#include "structure/elements/shell/full_integration.h"
#include "structure/elements/shell/group.h"

// What shells store, from their stresses (StoredEnergy).
namespace birdstrike
{
  namespace
  {
    /// Mean energy per undeformed volume of plane stress and transverse shear (J/m^3). What is linear through the
    /// thickness has a third of the density at the faces.
    Lanes compute_density(const SectionLaw &law, const SectionStress<Lanes> &s,
                          const AlignedVector<ShellPoint<Lanes>> &points)
    {
      Lanes density = (0.5 / law.shear_modulus) * (s.shear[0] * s.shear[0] + s.shear[1] * s.shear[1]);
      if (points.empty())
        return density + plane_stress_energy(law.elasticity, s.mean) +
               (1. / 3.) * plane_stress_energy(law.elasticity, s.outer);
      for (unsigned int k = 0; k < law.rule.n; ++k)
        density += (0.5 * law.rule.weight[k]) * plane_stress_energy(law.elasticity, points[k].stress);
      return density;
    }
  } // namespace

  Lanes ShellGroup::contraction(const std::size_t batch, const std::size_t k) const
  {
    return laminate ? laminate_contraction(laminate->states[n_in_plane * batch + k])
                    : law.contraction(section_of(batch, k));
  }

  StoredEnergy::State ShellGroup::stored(const std::size_t k) const
  {
    const std::size_t           b = k / n_in_plane, point = k % n_in_plane;
    const BatchNodes            nodes(place.records->position, batches[b].record);
    const auto                  geometry = ShellGeometry<Lanes>::of_corners(nodes.position, nodes.normal);
    const SectionStress<Lanes> &s        = section_of(b, point);
    Lanes                       area     = geometry.area;
    if (n_in_plane > 1)
      area = full_integration::PlaneGeometry<Lanes>(geometry, law.elasticity.poisson).point[point].area;
    area *= batches[b].owned;
    if (erosion)
      area *= erosion->batches[b].alive;
    if (laminate)
      return {{laminate_energy(laminate->states[k]), Lanes(0.)}, s.thickness * area * contraction(b, point)};
    return {{compute_density(law, s, points_of(b, point)), Lanes(0.)}, s.thickness * area * law.contraction(s)};
  }
} // namespace birdstrike
