#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cstddef>
#include <limits>

namespace birdstrike
{
  /// How the flow stress grows with the equivalent plastic strain p.
  enum class HardeningLaw
  {
    elastic,      ///< never yields
    perfect,      ///< s = A
    linear,       ///< s = A + B p
    swift,        ///< s = A (1 + p / e0)^n                     (Swift 1952)
    voce,         ///< s = A + Q (1 - exp(-b p))                (Voce 1948)
    johnson_cook, ///< s = (A + B p^n) (1 + C ln r*) (1 - T*^m) (Johnson & Cook 1983, eq. 1)
    curve,        ///< s(p) by straight lines between points, constant beyond the last (LS-DYNA: *MAT_024, LCSS)
  };

  enum class RateLaw
  {
    johnson_cook,   ///< 1 + C ln(max(p_dot/reference_rate, 1)), C = rate_factor
    cowper_symonds, ///< 1 + (p_dot/D)^(1/P), D = reference_rate, P = rate_exponent (Cowper & Symonds 1957)
  };

  /// A flow stress by points: straight segments that rise or are level.
  struct HardeningCurve
  {
    static constexpr std::size_t most_points = 16;
    struct Segment
    {
      double begin, length, slope; ///< -, -, Pa
    };
    std::array<Segment, most_points - 1> segments{};
    std::size_t                          n_segments = 0;
  };

  /// Constants of a flow stress. A rate term (RateLaw) may be added to every law, Johnson and Cook's softening by
  /// heat_capacity > 0 (adiabatic: all plastic work times taylor_quinney heats).
  struct Hardening
  {
    HardeningLaw law      = HardeningLaw::perfect;
    double       yield    = 880e6; ///< A, Pa
    double       modulus  = 0.;    ///< B (linear, Johnson-Cook) or Q (Voce), Pa
    double       exponent = 1.;    ///< n (Swift, Johnson-Cook) or b (Voce), -
    double       strain   = 0.01;  ///< e0 (Swift), -

    RateLaw rate_law       = RateLaw::johnson_cook;
    double  rate_factor    = 0.; ///< C, -; of Cowper and Symonds 1. With 0 there is no rate term
    double  reference_rate = 1.; ///< 1/s
    double  rate_exponent  = 1.; ///< P, -

    HardeningCurve curve; ///< begins at `yield`

    double softening_exponent  = 1.; ///< m, -
    double heat_capacity       = 0.; ///< c_p, J/(kg K); 0: isothermal
    double density             = 1.; ///< kg/m^3, of the heated mass
    double taylor_quinney      = 0.9;
    double initial_temperature = 293.; ///< K
    double room_temperature    = 293.; ///< K, where T* = 0
    double melting_temperature = 0.;   ///< K, where T* = 1
  };

  /// Of a metal that flows at no stress that there is; finite, as laws that compute with a flow stress need.
  inline Hardening hardening_without_flow()
  {
    Hardening result;
    result.law   = HardeningLaw::perfect;
    result.yield = 1e30;
    return result;
  }

  /// Flow stress (Pa) and its derivative with respect to the plastic strain of the step (Pa).
  template <class Number>
  struct FlowStress
  {
    Number value;
    Number slope;
  };

  namespace internal
  {
    // Apart and by value: laws without them keep their registers.

    template <class Number>
    [[gnu::noinline]] Number value_on_curve(const Hardening &h, const Number p)
    {
      Number s(h.yield);
      for (std::size_t k = 0; k < h.curve.n_segments; ++k)
        {
          const auto &segment = h.curve.segments[k];
          s += segment.slope * min(max(Number(p - segment.begin), Number(0.)), Number(segment.length));
        }
      return s;
    }

    template <class Number>
    [[gnu::noinline]] Number slope_on_curve(const Hardening &h, const Number p)
    {
      Number slope(0.);
      for (std::size_t k = 0; k < h.curve.n_segments; ++k)
        {
          const auto  &segment = h.curve.segments[k];
          const Number into    = p - segment.begin;
          slope = select(into >= Number(0.) && into < Number(segment.length), Number(segment.slope), slope);
        }
      return slope;
    }

    /// (dp/(dt D))^(1/P), of the plastic strain dp of a step.
    template <class Number>
    [[gnu::noinline]] Number cowper_symonds_overstress(const Hardening &h, const Number dp, const double dt)
    {
      const Number some = max(dp, Number(1e-30));
      return select(dp > Number(0.), exp(log(some / (dt * h.reference_rate)) / h.rate_exponent), Number(0.));
    }

    /// The quasi-static curve s(p) and s'(p). Power laws start with a vertical tangent: below p = 1e-9 it is cut.
    template <class Number>
    inline FlowStress<Number> static_flow_stress(const Hardening &h, const Number &p)
    {
      switch (h.law)
        {
        case HardeningLaw::linear:
          return {h.yield + h.modulus * p, Number(h.modulus)};
        case HardeningLaw::swift:
          {
            const Number s = h.yield * exp(h.exponent * log(Number(1.) + p / h.strain));
            return {s, h.exponent * s / (h.strain + p)};
          }
        case HardeningLaw::voce:
          {
            const Number e = h.modulus * exp(-h.exponent * p);
            return {h.yield + h.modulus - e, h.exponent * e};
          }
        case HardeningLaw::johnson_cook:
          {
            const Number q = max(p, Number(1e-9)), s = h.modulus * exp(h.exponent * log(q));
            return {h.yield + s, h.exponent * s / q};
          }
        case HardeningLaw::curve:
          return {value_on_curve(h, p), slope_on_curve(h, p)};
        case HardeningLaw::elastic:
          return {Number(std::numeric_limits<double>::max()), Number(0.)};
        case HardeningLaw::perfect:
          break;
        }
      return {Number(h.yield), Number(0.)};
    }
  } // namespace internal

  namespace internal
  {
    /// Apart, and not for the iterations: what only laws with a rate term ask must not keep these from being inlined.
    template <class Number>
    [[gnu::noinline]] Number softened_static_stress(const Hardening &h, const Number &p, const Number &softening)
    {
      return static_flow_stress(h, p).value * softening;
    }
  } // namespace internal

  /// T* = (T - T_room)/(T_melt - T_room), cut to [0, 1], of the present temperature T (K); 0 where nothing heats.
  template <class Number>
  inline Number homologous_temperature(const Hardening &h, const Number &temperature)
  {
    if (h.heat_capacity <= 0.)
      return Number(0.);
    const Number ratio = (temperature - h.room_temperature) / (h.melting_temperature - h.room_temperature);
    return min(max(ratio, Number(0.)), Number(1.));
  }

  /// 1 - T*^m, with T the present temperature (K); 1 where nothing heats. A millionth is left of a molten metal, for a
  /// flow stress of zero has no direction to return in.
  template <class Number>
  inline Number thermal_softening(const Hardening &h, const Number &temperature)
  {
    if (h.heat_capacity <= 0.)
      return Number(1.);
    const Number t     = homologous_temperature(h, temperature);
    const Number power = exp(h.softening_exponent * log(max(t, Number(1e-300))));
    return max(Number(Number(1.) - select(t > Number(0.), power, Number(0.))), Number(1e-6));
  }

  /// Temperature (K) after the plastic work w (J/m^3) of an adiabatic process.
  template <class Number>
  inline Number adiabatic_temperature(const Hardening &h, const Number &plastic_work)
  {
    if (h.heat_capacity <= 0.)
      return Number(h.initial_temperature);
    return h.initial_temperature + (h.taylor_quinney / (h.density * h.heat_capacity)) * plastic_work;
  }

  /// Flow stress after the plastic strain grew from p to p + dp within dt (s), with given thermal softening. Lanes that
  /// are `fast` have the rate term, below the reference rate too, the others do not: an iteration for dp must not cross
  /// the kink at that rate, where the slope jumps by C s/dp.
  template <class Number, class Mask>
  inline FlowStress<Number> compute_flow_stress(const Hardening &h, const Number &p, const Number &dp, const double dt,
                                                const Number &softening, const Mask &fast)
  {
    FlowStress<Number> s = internal::static_flow_stress(h, Number(p + dp));
    if (h.rate_factor > 0.)
      {
        if (h.rate_law == RateLaw::cowper_symonds)
          {
            const Number over = internal::cowper_symonds_overstress(h, dp, dt);
            s.slope = s.slope * (Number(1.) + over) + s.value * over / (h.rate_exponent * max(dp, Number(1e-30)));
            s.value = s.value * (Number(1.) + over);
          }
        else
          {
            const Number rate   = dp / (dt * h.reference_rate);
            const Number factor = Number(1.) + h.rate_factor * log(select(fast, rate, Number(1.)));
            const Number growth = select(fast, h.rate_factor / max(dp, Number(1e-30)), Number(0.));
            s.slope             = s.slope * factor + s.value * growth;
            s.value             = s.value * factor;
          }
      }
    return {s.value * softening, s.slope * softening};
  }

  /// The same where dp is known.
  template <class Number>
  inline FlowStress<Number> compute_flow_stress(const Hardening &h, const Number &p, const Number &dp, const double dt,
                                                const Number &softening)
  {
    return compute_flow_stress(h, p, dp, dt, softening, dp > Number(dt * h.reference_rate));
  }

  /// Whether the flow in a step will be faster than the reference rate: whether the stress that is left at that rate,
  /// `stress_left(dp)` (Pa), is beyond the static flow stress. False everywhere for a law without a rate term.
  template <class Number, class StressLeft>
  [[gnu::always_inline]] inline auto is_fast_flow(const Hardening &h, const Number &p, const double dt,
                                                  const Number &softening, const StressLeft &stress_left)
  {
    const auto none = Number(0.) > Number(0.);
    if (h.rate_factor <= 0. || h.rate_law == RateLaw::cowper_symonds)
      return none;
    const Number kink(dt * h.reference_rate);
    return stress_left(kink) > internal::softened_static_stress(h, Number(p + kink), softening);
  }
} // namespace birdstrike
