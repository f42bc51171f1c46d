#include "mbs/linalg/record_memory.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>
#include <utility>
#ifdef __linux__
#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/vfs.h>
#include <unistd.h>
#endif

namespace liesl {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21, kVector = 64;

std::size_t rounded_up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

double* in_large_pages(std::size_t bytes) {
  const std::size_t alignment = bytes < kLargePage ? kVector : kLargePage;
  const std::size_t size = rounded_up(bytes, alignment);
  void* memory = std::aligned_alloc(alignment, size);
  if (!memory && size > 0) throw std::bad_alloc();
#ifdef __linux__
  if (alignment == kLargePage) madvise(memory, size, MADV_HUGEPAGE);  // or small ones, if refused
#endif
  return static_cast<double*>(memory);
}

#ifdef __linux__

/// A file on a disk that goes with its last use. @returns -1: there is none
int nameless_file() {
  std::error_code none;
  std::string name = (std::filesystem::temp_directory_path(none) / "liesl-XXXXXX").string();
  const int file = none ? -1 : mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return -1;
  unlink(name.c_str());
  struct statfs system {};
  if (fstatfs(file, &system) == 0 && system.f_type != TMPFS_MAGIC && system.f_type != RAMFS_MAGIC)
    return file;
  close(file);
  return -1;
}

/// Null: no file has the room.
double* in_a_file(std::size_t bytes) {
  const int file = nameless_file();
  if (file < 0) return nullptr;
  void* memory = MAP_FAILED;
  if (fallocate(file, 0, 0, static_cast<off_t>(bytes)) == 0)
    memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<double*>(memory);
}

#else

double* in_a_file(std::size_t) { return nullptr; }

#endif

}  // namespace

RecordMemory::RecordMemory(RecordMemory&& other) noexcept { *this = std::move(other); }

RecordMemory& RecordMemory::operator=(RecordMemory&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(capacity_, other.capacity_);
  std::swap(in_file_, other.in_file_);
  return *this;
}

RecordMemory::~RecordMemory() { release(); }

void RecordMemory::release() noexcept {
#ifdef __linux__
  if (in_file_) munmap(data_, capacity_ * sizeof(double));
#endif
  if (!in_file_) std::free(data_);
}

void RecordMemory::reserve(std::size_t doubles, std::size_t kept) {
  if (doubles <= capacity_) return;
  RecordMemory more;
  const std::size_t bytes = doubles * sizeof(double);
  if (bytes > kInMemory) more.data_ = in_a_file(bytes);
  more.in_file_ = more.data_ != nullptr;
  if (!more.in_file_) more.data_ = in_large_pages(bytes);
  more.capacity_ = doubles;
  if (kept > 0) std::copy_n(data_, kept, more.data_);
  *this = std::move(more);
}

void RecordMemory::let_go([[maybe_unused]] std::size_t first,
                          [[maybe_unused]] std::size_t last) const {
#ifdef __linux__
  if (!in_file_) return;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t begin = rounded_up(first * sizeof(double), page),
                    end = last * sizeof(double) / page * page;
  if (begin < end) madvise(reinterpret_cast<char*>(data_) + begin, end - begin, MADV_DONTNEED);
#endif
}

}  // namespace liesl
