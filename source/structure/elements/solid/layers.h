#pragma once

#include "structure/elements/solid/solid_shell.h"

#include <algorithm>

namespace birdstrike
{
  namespace solid_shell
  {
    /// Work per volume (J/m^3) of one step: plastic work of the points without what varies in the plane, and minus what
    /// flow takes of the elastic energy of the latter.
    template <class Number>
    struct LayerWork
    {
      Number plastic, varying;
    };

    /// One step of the points through the thickness of a solid-shell; theory: solid_shell.h.
    template <class Number>
    struct Layers
    {
      const SolidLaw        &law;
      const ThicknessPoints &rule;

      /// Points of a stress state that is elastic so far.
      void promote(LayerPoint<Number> *points) const
      {
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            for (Number &s : points[k].residual)
              s = Number(0.);
            points[k].plastic_strain = points[k].plastic_work = Number(0.);
            points[k].yield                                   = Number(law.initial_yield());
          }
      }

      using Mask = typename SolidShellReturn<Number>::Mask;

      /// `mean` and `s`: of the elastic trial in, admissible out; `axes` and `x` of the end of the step. Lanes that
      /// cannot yield keep all they have, as does every lane whose points do not.
      LayerWork<Number> update(const SolidModes<Number> &x, const one_point_solid::Axes<Number> &axes, const double dt,
                               const Mask &can_yield, SolidPoint<Number> &mean,
                               one_point_solid::Stabilisation<Number> &s, LayerPoint<Number> *points) const
      {
        const Frame<Number>      frame(x, axes);
        const Squares<Number>    squares(s);
        Number                   of_mean[5], stress[max_thickness_points][5];
        SolidShellReturn<Number> section(law.elasticity, law.hardening, rule);
        frame.turn_in(mean.stress, of_mean);
        Mask yields(false);
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            const double z = rule.position[k];
            for (int c = 0; c < 5; ++c)
              stress[k][c] = of_mean[c] + points[k].residual[c] + (c < 3 ? Number(z * s.linear[2][c]) : Number(0.));
            const auto &t       = stress[k];
            auto       &p       = section.point[k];
            p.trace             = t[0];
            p.rest              = compute_rest(t);
            p.varying           = squares.varying + (z * z) * squares.bent;
            p.yield             = points[k].yield;
            const Number trial2 = 0.25 * t[0] * t[0] + p.rest + p.varying;
            yields              = yields || trial2 > p.yield * p.yield;
          }
        yields = yields && can_yield;
        if (!any(yields))
          return {Number(0.), Number(0.)};
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            section.point[k].plastic_strain = points[k].plastic_strain;
            section.point[k].softening      = law.compute_softening(points[k].plastic_work);
          }
        section.solve(dt, yields);
        const LayerWork<Number> work = flow(section, dt, yields, stress, s, points);
        store(frame, section.shift, yields, of_mean, stress, mean, s, points);
        return work;
      }

    private:
      /// Stresses, strains and work of the points after the return.
      LayerWork<Number> flow(const SolidShellReturn<Number> &section, const double dt, const Mask &yields,
                             Number (&stress)[max_thickness_points][5], one_point_solid::Stabilisation<Number> &s,
                             LayerPoint<Number> *points) const
      {
        Number plastic = 0., mean_factor = 0., moment_factor = 0.;
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            const auto  &p = section.point[k];
            const double z = rule.position[k], w = 0.5 * rule.weight[k];
            const Number q2 = section.square(p), strain = p.chi * sqrt(q2), work = p.chi * q2;
            stress[k][0] = p.trace_factor * section.shifted_trace(p);
            for (int c = 1; c < 5; ++c)
              stress[k][c] *= p.rest_factor;
            const Number yield = points[k].yield;
            law.add_flow(strain, work, dt, points[k]);
            points[k].yield = select(yields, points[k].yield, yield);
            plastic += w * (work - p.chi * (p.varying_factor * p.varying_factor * p.varying));
            mean_factor += w * p.varying_factor;
            moment_factor += (3. * w * z * z) * p.varying_factor;
          }
        mean_factor         = select(yields, mean_factor, Number(1.));
        moment_factor       = select(yields, moment_factor, Number(1.));
        const Number before = compute_varying_energy(law.elasticity, s);
        for (int k = 0; k < 2; ++k)
          {
            for (Number &component : s.linear[k])
              component *= mean_factor;
            s.last[k] *= moment_factor;
          }
        s.last[2] *= mean_factor;
        return {plastic, compute_varying_energy(law.elasticity, s) - before};
      }

      /// Mean, moment and residual stress of the points.
      void store(const Frame<Number> &frame, const Number &shift, const Mask &yields, Number (&old_mean)[5],
                 const Number (&stress)[max_thickness_points][5], SolidPoint<Number> &mean,
                 one_point_solid::Stabilisation<Number> &s, LayerPoint<Number> *points) const
      {
        Number sum[5], moment[3];
        for (int c = 0; c < 5; ++c)
          sum[c] = Number(0.);
        for (int c = 0; c < 3; ++c)
          moment[c] = Number(0.);
        mean.plastic_strain = Number(0.);
        for (unsigned int k = 0; k < rule.n; ++k)
          {
            const double z = rule.position[k], w = 0.5 * rule.weight[k];
            for (int c = 0; c < 5; ++c)
              sum[c] += w * stress[k][c];
            for (int c = 0; c < 3; ++c)
              moment[c] += (3. * w * z) * stress[k][c];
            mean.plastic_strain += w * points[k].plastic_strain;
          }
        for (unsigned int k = 0; k < rule.n; ++k)
          for (int c = 0; c < 5; ++c)
            {
              const Number varying  = c < 3 ? Number(rule.position[k] * moment[c]) : Number(0.);
              points[k].residual[c] = select(yields, Number(stress[k][c] - sum[c] - varying), points[k].residual[c]);
            }
        for (int c = 0; c < 5; ++c)
          old_mean[c] = select(yields, Number(sum[c] - old_mean[c]), Number(0.));
        frame.add_to(old_mean, shift, mean.stress);
        for (int c = 0; c < 3; ++c)
          s.linear[2][c] = select(yields, moment[c], s.linear[2][c]);
      }
    };
  } // namespace solid_shell
} // namespace birdstrike
