#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/material/hardening.h>

#include <array>
#include <cstddef>

namespace birdstrike
{
  /// What makes a point of metal fail.
  enum class FailureLaw
  {
    none,
    plastic_strain, ///< the equivalent plastic strain reaches a limit
    johnson_cook    ///< accumulated damage (Johnson & Cook 1985)
  };

  /// Factors on the failure strain by the size of an element: straight lines between points, constant beyond both ends,
  /// 1 without any (LS-DYNA: *MAT_ADD_DAMAGE_GISSMO, LCREGD; Radioss: /FAIL/TAB1, fct_IDel).
  ///
  /// A metal that fails at a strain tears by rows of elements: the finer they are, the less work a crack takes. With
  /// e_f(h) h the same on all meshes, a crack that is one row wide takes the same work on all of them (the crack band
  /// of Z. P. Bazant, B. H. Oh, Materiaux et Constructions 16 (1983) 155); real metals neck first over about a
  /// thickness, and a factor is what tests of one specimen ask for on several meshes.
  struct SizeFactors
  {
    static constexpr std::size_t most_points = 16;

    struct Point
    {
      double size;   ///< m, growing from point to point
      double factor; ///< -, above 0
    };
    std::array<Point, most_points> points{};
    std::size_t                    n = 0;

    bool is_within(const double size) const
    {
      constexpr double round_off = 1e-9;
      return n == 0 || (size >= points[0].size * (1. - round_off) && size <= points[n - 1].size * (1. + round_off));
    }

    double at(const double size) const
    {
      if (n == 0)
        return 1.;
      std::size_t k = 0;
      while (k < n && points[k].size < size)
        ++k;
      if (k == 0 || k == n)
        return points[k == 0 ? 0 : n - 1].factor;
      const Point &a = points[k - 1], &b = points[k];
      return a.factor + (b.factor - a.factor) * (size - a.size) / (b.size - a.size);
    }
  };

  /// Constants of a failure law. A point has the damage
  ///   D = sum dp / e_f,
  /// with the increments dp of its equivalent plastic strain and the failure strain e_f of the state in which each of
  /// them happened, times the factor of its element's size; at D = 1 it fails and carries no stress from then on. Until
  /// then damage does not soften. Of a shell that is the stress in its plane: transverse shear belongs to the section,
  /// which has it until it fails as a whole.
  ///
  /// Johnson & Cook (Engineering Fracture Mechanics 21, 1985, eq. 5):
  ///   e_f = (D1 + D2 exp(D3 s*)) (1 + D4 ln r*) (1 + D5 T*),
  /// s* = mean stress / von Mises stress, positive in tension, so that metals have D3 < 0 as the paper prints it (some
  /// programs print -D3); r* = max(p_dot / reference rate, 1), see damage_reference_rate; T* is the homologous
  /// temperature, zero where nothing heats. The paper gives the law for s* <= 1.5: what lies beyond
  /// -1.5 and 1.5 counts as these. Below `smallest_strain` e_f is cut.
  struct Failure
  {
    FailureLaw            law            = FailureLaw::none;
    double                plastic_strain = 0.2;                    ///< limit, -
    std::array<double, 5> d              = {{0., 0., 0., 0., 0.}}; ///< D1 ... D5, -
    double                failed_share   = 1.; ///< of an element's points, at which all of it has failed, -
    /// Share of an element's stable step at first, below which it is taken away, as it is when turned inside out; 0:
    /// never, and such an element ends the run. -
    double smallest_step = 0.;
    /// Of e_f, by the size that an element has at first: of a shell the root of its area, of a brick the cube root of
    /// its volume.
    SizeFactors size_factors = {};

    static constexpr double smallest_strain = 1e-6, largest_triaxiality = 1.5;

    bool can_fail() const
    {
      return law != FailureLaw::none;
    }
  };

  /// e_f from s*, r* and T* (all -).
  template <class Number>
  inline Number compute_failure_strain(const Failure &f, const Number &triaxiality, const Number &rate,
                                       const Number &temperature)
  {
    if (f.law == FailureLaw::plastic_strain)
      return Number(f.plastic_strain);
    const double most    = Failure::largest_triaxiality;
    const Number bounded = max(Number(-most), min(triaxiality, Number(most)));
    const Number strain  = (f.d[0] + f.d[1] * exp(f.d[2] * bounded)) *
                          (Number(1.) + f.d[3] * log(max(rate, Number(1.)))) * (Number(1.) + f.d[4] * temperature);
    return max(strain, Number(Failure::smallest_strain));
  }

  /// The plastic strain of one step, the stress at its end and the temperature that it flowed at, of its start.
  template <class Number>
  struct PlasticStep
  {
    Number strain;      ///< dp, -
    Number mean_stress; ///< Pa, tr(s)/3
    Number von_mises;   ///< Pa
    Number temperature; ///< K
    double dt;          ///< s
  };

  /// Of r*, 1/s: the one that Johnson and Cook's strength is given with, since both are fitted together; with another
  /// rate law 1/s, to which the paper normalises. D of Cowper and Symonds is the rate that doubles the stress.
  inline double damage_reference_rate(const Hardening &h)
  {
    return h.rate_law == RateLaw::johnson_cook ? h.reference_rate : 1.;
  }

  /// What a step adds to D.
  template <class Number>
  inline Number compute_damage_increment(const Failure &f, const Hardening &h, const PlasticStep<Number> &step)
  {
    const Number tiny(1e-300);
    return step.strain / compute_failure_strain(f, Number(step.mean_stress / max(step.von_mises, tiny)),
                                                Number(step.strain / (step.dt * damage_reference_rate(h))),
                                                homologous_temperature(h, step.temperature));
  }
} // namespace birdstrike
