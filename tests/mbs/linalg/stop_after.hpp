#pragma once
/// @file
/// Somebody who wants a calculation to stop once it has looked so many times.

#include <atomic>

#include "mbs/linalg/stop_request.hpp"

namespace liesl::test {

class StopAfter {
 public:
  explicit StopAfter(int looks) {
    left() = looks;
    ask_for_stop([] { return --left() < 0; });
  }
  ~StopAfter() { ask_for_stop(nullptr); }
  StopAfter(const StopAfter&) = delete;
  StopAfter& operator=(const StopAfter&) = delete;
  int unused() const { return left(); }

 private:
  static std::atomic<int>& left() {
    static std::atomic<int> count;
    return count;
  }
};

}  // namespace liesl::test
