/// @file
/// OpenBLAS asks for its buffers until it gets them: where there is no address space left it would
/// ask for ever, in any call of it. The program therefore answers its mmap itself. Of the program
/// only: not part of any library.

#include "apps/cli/out_of_memory.hpp"

#include <sys/mman.h>
#include <sys/syscall.h>

#include <cerrno>

#include "mbs/linalg/sanitized.hpp"

#ifndef LIESL_SANITIZED  // which has an mmap of its own

/// As the system's, but the end of the program where anonymous memory is refused. The C library and
/// `new` do not come through here: they have std::bad_alloc.
extern "C" void* mmap(void* address, size_t size, int protection, int flags, int file,
                      off_t offset) noexcept {
  const long got = ::syscall(SYS_mmap, address, size, protection, flags, file, offset);
  if (got == -1 && errno == ENOMEM && (flags & MAP_ANONYMOUS)) liesl::end_out_of_memory();
  return reinterpret_cast<void*>(got);
}

#endif
