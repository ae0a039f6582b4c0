#pragma once

#include <birdstrike/core/number.h>

#include <cmath>

namespace birdstrike::benchmarks
{
  /// A double that counts what is done to it: physics that is a template on the number type is run once with it, and
  /// its flops follow from the source as it stands. Rules: flops.h.
  struct Counted
  {
    double value = 0.;

    Counted() = default;
    Counted(const double value) : value(value)
    {
    }

    static inline double flops = 0.;

    static Counted of(const double value, const double cost = 1.)
    {
      flops += cost;
      return {value};
    }

    Counted &operator+=(const Counted &b)
    {
      return *this = of(value + b.value);
    }
    Counted &operator-=(const Counted &b)
    {
      return *this = of(value - b.value);
    }
    Counted &operator*=(const Counted &b)
    {
      return *this = of(value * b.value);
    }
    Counted &operator/=(const Counted &b)
    {
      return *this = of(value / b.value);
    }
    Counted operator-() const
    {
      return {-value};
    }
    friend Counted operator+(Counted a, const Counted &b)
    {
      return a += b;
    }
    friend Counted operator-(Counted a, const Counted &b)
    {
      return a -= b;
    }
    friend Counted operator*(Counted a, const Counted &b)
    {
      return a *= b;
    }
    friend Counted operator/(Counted a, const Counted &b)
    {
      return a /= b;
    }
    friend auto operator<=>(const Counted &a, const Counted &b)
    {
      return a.value <=> b.value;
    }
    friend bool operator==(const Counted &a, const Counted &b)
    {
      return a.value == b.value;
    }
  };

  inline Counted sqrt(const Counted &a)
  {
    return Counted::of(std::sqrt(a.value));
  }
  /// As the loops compute it: an estimate by the hardware and two Newton steps.
  inline Counted inverse_root(const Counted &a)
  {
    return Counted::of(1. / std::sqrt(a.value), 9.);
  }
  inline Counted exp(const Counted &a)
  {
    return Counted::of(std::exp(a.value), 20.);
  }
  inline Counted log(const Counted &a)
  {
    return Counted::of(std::log(a.value), 20.);
  }
  inline Counted abs(const Counted &a)
  {
    return {std::abs(a.value)};
  }
  inline Counted min(const Counted &a, const Counted &b)
  {
    return a < b ? a : b;
  }
  inline Counted max(const Counted &a, const Counted &b)
  {
    return a < b ? b : a;
  }
  inline Counted select(const bool mask, const Counted &a, const Counted &b)
  {
    return mask ? a : b;
  }

  /// Flops of a piece of work.
  template <class Body>
  double count_flops(const Body &body)
  {
    const double before = Counted::flops;
    body();
    return Counted::flops - before;
  }
} // namespace birdstrike::benchmarks

namespace Eigen
{
  template <>
  struct NumTraits<birdstrike::benchmarks::Counted> : GenericNumTraits<double>
  {
    using Real       = birdstrike::benchmarks::Counted;
    using NonInteger = birdstrike::benchmarks::Counted;
    using Nested     = birdstrike::benchmarks::Counted;
    using Literal    = double;
    enum
    {
      RequireInitialization = 1
    };
  };
} // namespace Eigen
