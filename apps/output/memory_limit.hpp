#pragma once
/// @file
/// Whether memory may run out.

#include <sys/resource.h>

#include <future>

namespace liesl::output {

/// Has the process less address space than it asks for (`ulimit -v`, a batch's `limits.memory`)?
/// HDF5 1.10 does not survive that there is none left, hence files are then used one thing after
/// the other, while there is some.
inline bool memory_is_limited() {
  rlimit space{};
  return ::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur != RLIM_INFINITY;
}

/// How files are used while other work goes on: beside it, if the system has a thread for it, or by
/// who waits for them.
inline std::launch beside() {
  return memory_is_limited() ? std::launch::deferred : std::launch::async | std::launch::deferred;
}

}  // namespace liesl::output
