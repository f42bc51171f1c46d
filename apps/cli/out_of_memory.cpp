/// @file
/// The end of a program without address space. OpenBLAS asks for its buffers until it gets them:
/// where there is none left (a limit on the address space) it would ask for ever, in any call of
/// it. The program therefore answers its mmap itself. Of the program only: not part of any library.

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#ifndef __SANITIZE_ADDRESS__  // which has an mmap of its own

namespace {

constexpr std::string_view kMessage =
    "liesl: out of memory; use fewer elements, a larger step or output_every, or allow it more "
    "address space (the linear algebra alone takes 128 MB a thread)\n";
constexpr int kFailed = 3;
constexpr rlim_t kLeast = rlim_t{96} << 20;  // the libraries, and a stack for a thread of OpenBLAS

[[noreturn]] void end() {
  (void)!::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  ::_exit(kFailed);
}

/// OpenBLAS begins its threads while it is loaded, and sends an interrupt where it cannot.
void before_libraries_begin(int, char**, char**) {
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur < kLeast) end();
}
[[gnu::used, gnu::section(".preinit_array")]] void (*const first)(int, char**,
                                                                  char**) = &before_libraries_begin;

}  // namespace

/// As the system's, but the end of the program where anonymous memory is refused. The C library and
/// `new` do not come through here: they have std::bad_alloc.
extern "C" void* mmap(void* address, size_t size, int protection, int flags, int file,
                      off_t offset) noexcept {
  const long got = ::syscall(SYS_mmap, address, size, protection, flags, file, offset);
  if (got == -1 && errno == ENOMEM && (flags & MAP_ANONYMOUS)) end();
  return reinterpret_cast<void*>(got);
}

#endif
