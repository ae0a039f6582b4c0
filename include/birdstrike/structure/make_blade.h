#pragma once

#include <birdstrike/core/thread_pool.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/parameters.h>

#include <memory>

namespace birdstrike
{
  /// The blade that the parameters ask for; null for kind "none". Throws InputError. The pool must outlive the blade.
  std::unique_ptr<Blade> make_blade(const BladeParameters &parameters, ThreadPool &pool);
} // namespace birdstrike
