/// @file
/// How the programs of this folder take time: processor time, and the median of repetitions.
#pragma once

#include <algorithm>
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

/// The middle of at least one repetition (of an even number the upper one).
inline double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

}  // namespace liesl
