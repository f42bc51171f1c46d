#include "mbs/linalg/large_pages.hpp"

#include <cstdlib>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace liesl {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21, kVector = 64;

std::size_t rounded_up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

}  // namespace

void* allocate_in_large_pages(std::size_t bytes) {
  const std::size_t alignment = bytes < kLargePage ? kVector : kLargePage;
  const std::size_t size = rounded_up(bytes, alignment);
  void* memory = std::aligned_alloc(alignment, size);
  if (!memory && size > 0) throw std::bad_alloc();
#ifdef __linux__
  if (alignment == kLargePage) madvise(memory, size, MADV_HUGEPAGE);  // or small ones, if refused
#endif
  return memory;
}

void free_large_pages(void* memory) noexcept { std::free(memory); }

}  // namespace liesl
