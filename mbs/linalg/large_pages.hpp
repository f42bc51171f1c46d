#pragma once
/// @file
/// Memory of long records: in large pages, where the system has them on request. The first touch of
/// a small page takes longer than the step of a planar beam that fills half of it.

#include <cstddef>
#include <new>
#include <utility>

namespace liesl {

/// @returns memory for `bytes`, aligned for every vector of the processor
/// @throws std::bad_alloc
void* allocate_in_large_pages(std::size_t bytes);
void free_large_pages(void* memory) noexcept;

/// An allocator for std::vector; elements that are not given a value are left as they are, so that
/// room that is not used yet takes no memory.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_in_large_pages(n * sizeof(T))); }
  void deallocate(T* p, std::size_t) noexcept { free_large_pages(p); }
  template <class U>
  void construct(U* p) noexcept {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

}  // namespace liesl
