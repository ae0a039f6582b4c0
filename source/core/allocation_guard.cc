#include <birdstrike/core/allocation_guard.h>

#if !defined(NDEBUG) || defined(BIRDSTRIKE_COUNT_ALLOCATIONS)

#  include <execinfo.h>

#  include <algorithm>
#  include <array>
#  include <atomic>
#  include <cstdlib>
#  include <new>

namespace
{
  constexpr std::size_t n_stacks = 64, n_frames = 10;

  std::atomic<bool>                                  armed{false};
  std::atomic<std::uint64_t>                         n_counted{0};
  thread_local bool                                  is_exempt = false;
  std::array<std::array<void *, n_frames>, n_stacks> stacks{};
  std::array<int, n_stacks>                          depths{};
  std::atomic<std::size_t>                           n_kept{0};

  void count_one()
  {
    if (!armed.load(std::memory_order_relaxed) || is_exempt)
      return;
    n_counted.fetch_add(1, std::memory_order_relaxed);
    if (const std::size_t k = n_kept.fetch_add(1); k < n_stacks)
      depths[k] = ::backtrace(stacks[k].data(), n_frames);
  }

  void *allocate(const std::size_t size)
  {
    count_one();
    return std::malloc(std::max<std::size_t>(size, 1));
  }

  void *allocate(const std::size_t size, const std::align_val_t alignment)
  {
    count_one();
    const auto unit = static_cast<std::size_t>(alignment);
    return std::aligned_alloc(unit, (std::max<std::size_t>(size, 1) + unit - 1) / unit * unit);
  }

  void *require(void *const memory)
  {
    if (!memory)
      throw std::bad_alloc();
    return memory;
  }
} // namespace

// All forms of new and delete of single objects: a sanitizer would else bring some of them, and take memory of the
// others for a mistake. Those of arrays call these, or are the sanitizer's, every one.
void *operator new(const std::size_t size)
{
  return require(allocate(size));
}

void *operator new(const std::size_t size, const std::align_val_t alignment)
{
  return require(allocate(size, alignment));
}

void *operator new(const std::size_t size, const std::nothrow_t &) noexcept
{
  return allocate(size);
}

void *operator new(const std::size_t size, const std::align_val_t alignment, const std::nothrow_t &) noexcept
{
  return allocate(size, alignment);
}

void operator delete(void *const memory) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, const std::nothrow_t &) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, std::align_val_t, const std::nothrow_t &) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, std::align_val_t) noexcept
{
  std::free(memory);
}

void operator delete(void *const memory, std::size_t, std::align_val_t) noexcept
{
  std::free(memory);
}

namespace birdstrike
{
  AllocationGuard::AllocationGuard(const bool is_armed)
  {
    // the first call of backtrace loads a library, which allocates
    static std::array<void *, 2>      frame;
    [[maybe_unused]] static const int depth = ::backtrace(frame.data(), frame.size());
    n_counted                               = 0;
    n_kept                                  = 0;
    armed                                   = is_armed;
  }

  AllocationGuard::~AllocationGuard()
  {
    armed = false;
  }

  std::uint64_t AllocationGuard::count() const
  {
    return n_counted;
  }

  bool AllocationGuard::is_counting()
  {
    return true;
  }

  void AllocationGuard::exempt_this_thread()
  {
    is_exempt = true;
  }

  std::string AllocationGuard::first_call_sites()
  {
    std::string text;
    for (std::size_t k = 0; k < std::min<std::size_t>(n_kept, n_stacks); ++k)
      {
        char **const names = ::backtrace_symbols(stacks[k].data(), depths[k]);
        text += "allocation " + std::to_string(k + 1) + "\n";
        for (int frame = 2; names && frame < depths[k]; ++frame)
          text += std::string("  ") + names[frame] + "\n";
        std::free(names);
      }
    return text;
  }
} // namespace birdstrike

#else

namespace birdstrike
{
  AllocationGuard::AllocationGuard(bool)
  {
  }

  AllocationGuard::~AllocationGuard() = default;

  std::uint64_t AllocationGuard::count() const
  {
    return 0;
  }

  bool AllocationGuard::is_counting()
  {
    return false;
  }

  void AllocationGuard::exempt_this_thread()
  {
  }

  std::string AllocationGuard::first_call_sites()
  {
    return "";
  }
} // namespace birdstrike

#endif
