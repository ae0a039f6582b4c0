#pragma once

// GCC 12 says "__Y may be used uninitialized" inside its own AVX-512 intrinsics (GCC bug 105593): silenced where these
// are first included, and nowhere else.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <experimental/simd>
#pragma GCC diagnostic pop

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

/// The number types on which physics is written once: `double` in a unit test, `Lanes` in the loop.
///
/// `Lanes` is one SIMD register of doubles (8 with AVX-512, 4 with AVX2, 2 with SSE2). A formula is a template on
/// `Number` and uses the functions below, which mean the same on both; branches become `select(mask, a, b)`.
/// This is the only SIMD abstraction of physics (ISO/IEC TS 19570:2018, section 9, as shipped by GCC >= 11); what moves
/// data between registers and memory stands in core/simd.
namespace birdstrike
{
  namespace stdx = std::experimental;

  using Lanes      = stdx::native_simd<double>;
  using LanesMask  = Lanes::mask_type;
  using FloatLanes = stdx::native_simd<float>;

  inline constexpr std::size_t n_lanes = Lanes::size();

  template <class Number>
  inline constexpr std::size_t lanes_of = 1;
  template <>
  inline constexpr std::size_t lanes_of<Lanes> = n_lanes;

  /// a where mask is true, else b.
  inline double select(const bool mask, const double a, const double b)
  {
    return mask ? a : b;
  }
  template <class T, class Abi>
  inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi> &mask, const stdx::simd<T, Abi> &a,
                                   const stdx::simd<T, Abi> &b)
  {
    stdx::simd<T, Abi> result = b;
    stdx::where(mask, result) = a;
    return result;
  }
  template <class T, class Abi>
  inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi> &mask, const T a, const stdx::simd<T, Abi> &b)
  {
    return select(mask, stdx::simd<T, Abi>(a), b);
  }
  template <class T, class Abi>
  inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi> &mask, const stdx::simd<T, Abi> &a, const T b)
  {
    return select(mask, a, stdx::simd<T, Abi>(b));
  }

  inline bool any(const bool mask)
  {
    return mask;
  }
  inline bool all(const bool mask)
  {
    return mask;
  }
  template <class T, class Abi>
  inline bool any(const stdx::simd_mask<T, Abi> &mask)
  {
    return stdx::any_of(mask);
  }
  template <class T, class Abi>
  inline bool all(const stdx::simd_mask<T, Abi> &mask)
  {
    return stdx::all_of(mask);
  }

  // Elementary functions; argument-dependent look-up finds std::experimental's for Lanes.
  using std::abs;
  using std::cbrt;
  using std::exp;
  using std::log;
  using std::pow;
  using std::sqrt;
  using stdx::exp;
  using stdx::log;
  using stdx::sqrt;

  inline double min(const double a, const double b)
  {
    return a < b ? a : b;
  }
  inline double max(const double a, const double b)
  {
    return a < b ? b : a;
  }
  // stdx::min and stdx::max are found by argument; a template of the same signature here would be ambiguous.
  using stdx::max;
  using stdx::min;

  /// Lane k of a number; for `double` the number itself.
  inline double lane(const double a, std::size_t)
  {
    return a;
  }
  inline double lane(const Lanes &a, const std::size_t k)
  {
    return a[k];
  }

  /// n_lanes consecutive doubles from memory (any alignment), or one double.
  template <class Number>
  inline Number load(const double *p);
  template <>
  inline double load<double>(const double *p)
  {
    return *p;
  }
  template <>
  inline Lanes load<Lanes>(const double *p)
  {
    return Lanes(p, stdx::element_aligned);
  }
  /// The same from floats, and back to them rounded.
  template <class Number>
  inline Number load(const float *p);
  template <>
  inline double load<double>(const float *p)
  {
    return *p;
  }
  template <>
  inline Lanes load<Lanes>(const float *p)
  {
    return Lanes(p, stdx::element_aligned);
  }
  /// values[index[k]] for the lanes k of one register.
  inline Lanes gather(const double *values, const std::uint32_t *index)
  {
    return Lanes([&](const auto k) { return values[index[k]]; });
  }
  inline void store(const double a, float *p)
  {
    *p = static_cast<float>(a);
  }
  inline void store(const Lanes &a, float *p)
  {
    a.copy_to(p, stdx::element_aligned);
  }
  inline void store(const double a, double *p)
  {
    *p = a;
  }
  inline void store(const Lanes &a, double *p)
  {
    a.copy_to(p, stdx::element_aligned);
  }

  /// Calls f(Lanes(), p) for whole registers p, p + n_lanes, ... of [begin, end) and f(double(), p) for the rest: `f`
  /// is written once, with decltype of its first argument as number type.
  template <class Function>
  inline void sweep(const std::size_t begin, const std::size_t end, const Function &f)
  {
    std::size_t p = begin;
    for (; p + n_lanes <= end; p += n_lanes)
      f(Lanes(), p);
    for (; p < end; ++p)
      f(double(), p);
  }
} // namespace birdstrike

namespace Eigen
{
  /// Lets a SIMD register be the scalar of an Eigen vector or matrix.
  template <class T, class Abi>
  struct NumTraits<std::experimental::simd<T, Abi>> : GenericNumTraits<T>
  {
    using Simd       = std::experimental::simd<T, Abi>;
    using Real       = Simd;
    using NonInteger = Simd;
    using Nested     = Simd;
    using Literal    = T;
    enum
    {
      IsComplex             = 0,
      IsInteger             = 0,
      IsSigned              = 1,
      RequireInitialization = 0,
      ReadCost              = 1,
      AddCost               = 1,
      MulCost               = 1
    };
  };
} // namespace Eigen

namespace birdstrike
{
  template <class Number>
  using Vector3 = Eigen::Matrix<Number, 3, 1>;
  template <class Number>
  using Matrix3 = Eigen::Matrix<Number, 3, 3>;
  using Point3  = Vector3<double>;
} // namespace birdstrike
