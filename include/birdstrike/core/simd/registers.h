#pragma once

#include <cstring>

namespace birdstrike
{
  /// Four and eight numbers of a node (or of neighbouring nodes): a register, or a pair of them where none is so wide.
  using Four  = double __attribute__((vector_size(32)));
  using Eight = double __attribute__((vector_size(64)));

  template <class Register>
  [[gnu::always_inline]] inline void read(const double *p, Register &r)
  {
    std::memcpy(&r, p, sizeof r);
  }
  template <class Register>
  [[gnu::always_inline]] inline void write(const Register &r, double *p)
  {
    std::memcpy(p, &r, sizeof r);
  }
} // namespace birdstrike
