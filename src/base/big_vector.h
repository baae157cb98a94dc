#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace repose {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;  ///< bytes

/// Allocates large blocks on huge pages where the system grants them: neighbours in space are not neighbours in memory,
/// and with small pages their addresses cost as much to translate as their contents to fetch.
template <class T>
struct HugePageAllocator {
  using value_type = T;

  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}  // NOLINT(google-explicit-constructor): the standard asks for it

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < huge_page) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
    void* block = ::operator new(bytes, std::align_val_t(huge_page));
    madvise(block, bytes, MADV_HUGEPAGE);  // a wish: small pages serve as well
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t count) {
    const std::size_t alignment = count * sizeof(T) < huge_page ? alignof(T) : huge_page;
    ::operator delete(block, std::align_val_t(alignment));
  }
  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

/// A vector that the hot loops run over.
template <class T>
using BigVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace repose
