#pragma once

#include <functional>
#include <memory>
#include <type_traits>

namespace birdstrike
{
  template <class Signature>
  class FunctionRef;

  /// Refers to a callable that outlives it, e.g. the lambda in a call of ThreadPool::parallel_for: two pointers, where
  /// std::function copies the callable and allocates for what exceeds 16 bytes.
  template <class Result, class... Arguments>
  class FunctionRef<Result(Arguments...)>
  {
  public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             std::is_invocable_r_v<Result, Function &, Arguments...>) FunctionRef(Function &&function)
      : target(const_cast<void *>(static_cast<const void *>(std::addressof(function))))
      , invoke([](void *const f, Arguments... arguments) -> Result {
        return std::invoke(*static_cast<std::remove_reference_t<Function> *>(f), arguments...);
      })
    {
    }

    Result operator()(Arguments... arguments) const
    {
      return invoke(target, arguments...);
    }

  private:
    void *target;
    Result (*invoke)(void *, Arguments...);
  };
} // namespace birdstrike
