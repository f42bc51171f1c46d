#include "python/module/job.hpp"

#include <mutex>
#include <vector>

namespace liesl::python {
namespace {

std::mutex mutex;
std::vector<std::thread>& left() {
  static auto* threads = new std::vector<std::thread>;  // joined before the end, never destroyed
  return *threads;
}

}  // namespace

void leave(std::thread thread) {
  const std::lock_guard lock(mutex);
  left().push_back(std::move(thread));
}

void join_left() {
  const py::gil_scoped_release unlocked;
  std::vector<std::thread> threads;
  {
    const std::lock_guard lock(mutex);
    threads.swap(left());
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace liesl::python
