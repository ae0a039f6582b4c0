#include "memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{
  std::atomic<std::size_t>   in_use{0};
  std::atomic<unsigned long> allocations{0};

  void *book(void *p)
  {
    if (p == nullptr)
      throw std::bad_alloc();
    in_use.fetch_add(malloc_usable_size(p), std::memory_order_relaxed);
    allocations.fetch_add(1, std::memory_order_relaxed);
    return p;
  }

  void release(void *p)
  {
    if (p != nullptr)
      in_use.fetch_sub(malloc_usable_size(p), std::memory_order_relaxed);
    std::free(p);
  }
} // namespace

// The array, sized and nothrow forms of the library end in these four.
void *operator new(const std::size_t n)
{
  return book(std::malloc(n > 0 ? n : 1));
}
void *operator new(const std::size_t n, const std::align_val_t alignment)
{
  const auto a = static_cast<std::size_t>(alignment);
  return book(std::aligned_alloc(a, (n + a - 1) / a * a));
}
void operator delete(void *p) noexcept
{
  release(p);
}
void operator delete(void *p, std::size_t) noexcept
{
  release(p);
}
void operator delete(void *p, std::align_val_t) noexcept
{
  release(p);
}
void operator delete(void *p, std::size_t, std::align_val_t) noexcept
{
  release(p);
}

namespace birdstrike::benchmarks
{
  std::size_t bytes_in_use()
  {
    return in_use.load();
  }
  unsigned long n_allocations()
  {
    return allocations.load();
  }
} // namespace birdstrike::benchmarks
