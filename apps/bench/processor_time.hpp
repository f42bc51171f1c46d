/// @file
/// How the programs of this folder take time: processor time, time by the clock, and the median of
/// repetitions.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

namespace liesl {

/// Processor time of a call, all threads together [s].
inline double seconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Time of a call by the clock [s]: less than the processor's where threads share the work.
inline double clock_seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of calls, both.
struct TwoTimes {
  std::vector<double> processor, clock;
  void take(const std::function<void()>& work) {
    double by_clock = 0;
    processor.push_back(seconds([&] { by_clock = clock_seconds(work); }));
    clock.push_back(by_clock);
  }
};

using Clock = double (*)(const std::function<void()>&);

/// The middle of at least one repetition (of an even number the upper one).
inline double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

}  // namespace liesl
