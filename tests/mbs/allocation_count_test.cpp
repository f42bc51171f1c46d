/// @file
/// Replaces operator new of the test program. Its own file, so that the compiler does not inline
/// one half of a new-delete pair.

#include "mbs/allocation_count.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size ? size : 1);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }

namespace liesl::test {

long allocation_count() { return allocations; }

TEST(AllocationCount, SeesAnAllocation) {
  const long before = allocation_count();
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocation_count(), before + 1);
}

}  // namespace liesl::test
