/// @file
/// `liesl` as it is called: a process of the C library alone that starts the program in its place.
/// Where the address space of the process is limited (`ulimit -v`, a batch's `limits.memory`), the
/// libraries of the program may not fit: the system's loader, or OpenBLAS, which begins a thread a
/// core while it is loaded, would then end it in words of their own.

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "apps/cli/out_of_memory.hpp"

namespace {

constexpr rlim_t kLibraries = rlim_t{80} << 20;      // what the program and its libraries map
constexpr rlim_t kBuffer = rlim_t{128} << 20;        // of OpenBLAS for a thread
constexpr rlim_t kUnlimitedStack = rlim_t{2} << 20;  // of a thread where no limit gives its size
constexpr int kFailed = 3;

/// As many threads of OpenBLAS as have stack and buffer in half of what the libraries leave.
rlim_t threads_within(rlim_t space) {
  rlimit stack{};
  if (::getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur == RLIM_INFINITY)
    stack.rlim_cur = kUnlimitedStack;
  const rlim_t others = (space - kLibraries) / 2 / (stack.rlim_cur + kBuffer);
  return 1 + std::min<rlim_t>(others, INT_MAX);
}

/// How many threads OpenBLAS would begin: its variables in its order, else a thread a core.
long threads_wanted() {
  for (const char* name : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"}) {
    const char* text = std::getenv(name);
    const long number = text ? std::strtol(text, nullptr, 10) : 0;
    if (number > 0) return number;
  }
  return ::sysconf(_SC_NPROCESSORS_ONLN);
}

void limit_threads(rlim_t space) {
  const long wanted = threads_wanted();
  const rlim_t threads = threads_within(space);
  if (wanted < 1 || threads >= static_cast<rlim_t>(wanted)) return;
  std::array<char, 16> number;
  std::snprintf(number.data(), number.size(), "%d", static_cast<int>(threads));
  ::setenv("OPENBLAS_NUM_THREADS", number.data(), 1);
}

}  // namespace

int main(int, char** words) {
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) {
    if (space.rlim_cur < kLibraries) liesl::end_out_of_memory();
    limit_threads(space.rlim_cur);
  }
  std::array<char, PATH_MAX> program{};
  constexpr char kProgram[] = "/" LIESL_PROGRAM;  // from the folder of this file
  const long room = static_cast<long>(program.size() - sizeof kProgram);
  const long length = ::readlink("/proc/self/exe", program.data(), static_cast<std::size_t>(room));
  if (length > 0 && length < room) {
    std::strcpy(std::strrchr(program.data(), '/'), kProgram);
    ::execv(program.data(), words);
  } else if (length > 0) {
    errno = ENAMETOOLONG;
  }
  std::fprintf(
      stderr,
      "liesl: cannot start its program, '%s' in the folder of bin/liesl: %s; install or copy "
      "all of liesl\n",
      LIESL_PROGRAM, std::strerror(errno));
  return kFailed;
}
