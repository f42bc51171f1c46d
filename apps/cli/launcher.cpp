/// @file
/// `liesl` as it is called: a process of the C library alone that starts the program in its place,
/// with one thread of OpenBLAS, which begins a thread a core while it is loaded: liesl uses one
/// (mbs/linalg/blas_threads.hpp), and the others wait in a loop after each call. Where the address
/// space of the process is limited (`ulimit -v`, a batch's `limits.memory`), the libraries of the
/// program may not fit: the system's loader would then end it in words of its own. What the program
/// was built from is told without loading it.

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "apps/cli/out_of_memory.hpp"
#include "apps/output/version_table.hpp"

namespace {

constexpr rlim_t kLibraries = rlim_t{80} << 20;  // what the program and its libraries map
constexpr int kFailed = 3;

void tell_versions() {
  for (const liesl::output::Version* v = liesl::output::kVersions; v->name; ++v)
    if (*v->version) std::printf("%s %s\n", v->name, v->version);
}

}  // namespace

int main(int count, char** words) {
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY &&
      space.rlim_cur < kLibraries)
    liesl::end_out_of_memory();
  ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
  std::array<char, PATH_MAX> program{};
  constexpr char kProgram[] = "/" LIESL_PROGRAM;  // from the folder of this file
  const long room = static_cast<long>(program.size() - sizeof kProgram);
  const long length = ::readlink("/proc/self/exe", program.data(), static_cast<std::size_t>(room));
  if (length > 0 && length < room) {
    std::strcpy(std::strrchr(program.data(), '/'), kProgram);
    if (count == 2 && std::strcmp(words[1], "--version") == 0 &&
        ::access(program.data(), X_OK) == 0)
      return tell_versions(), 0;
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
