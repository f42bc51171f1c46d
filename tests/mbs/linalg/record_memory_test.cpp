/// @file
/// Memory of long records: aligned, the same after it has moved, and out of the way where it is
/// long.
#include "mbs/linalg/record_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <utility>

namespace liesl::test::record_memory_test {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 19,  // doubles
    kLong = RecordMemory::kInMemory / sizeof(double) + 1000;

/// Of this process, bytes.
double resident() {
  std::ifstream in("/proc/self/statm");
  double all = 0, now = 0;
  in >> all >> now;
  return now * static_cast<double>(sysconf(_SC_PAGESIZE));
}

TEST(RecordMemory, KeepsWhatItHoldsAsItGrows) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1000},
                                 std::size_t{262144}, std::size_t{600001}, kLong}) {
    RecordMemory values;
    values.reserve(size, 0);
    for (std::size_t i = 0; i < size; ++i) values.data()[i] = static_cast<double>(i);
    values.reserve(size + 300000, size);
    RecordMemory grown = std::move(values);
    EXPECT_EQ(values.capacity(), 0u);
    EXPECT_GE(grown.capacity(), size + 300000);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(grown.data()[i], double(i)) << size;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(grown.data()) % 64, 0u) << size;
  }
}

TEST(RecordMemory, OfLongRecordsIsOutOfTheWay) {
  RecordMemory values;
  values.reserve(2 * kLong, 0);
  if (!values.in_file()) GTEST_SKIP() << "temporary files are in memory, or have no room";
  const double before = resident();
  double most = 0;
  const auto let_go = [&](std::size_t i) {
    if (i % kWindow != kWindow - 1) return;
    most = std::max(most, resident());
    values.let_go(i + 1 - kWindow, i + 1);
  };
  for (std::size_t i = 0; i < 2 * kLong; ++i) {
    values.data()[i] = static_cast<double>(i);
    let_go(i);
  }
  for (std::size_t i = 0; i < 2 * kLong; ++i) {
    ASSERT_EQ(values.data()[i], double(i));
    let_go(i);
  }
  EXPECT_LT(most - before, 16e6) << "of " << 2 * kLong * sizeof(double);
  EXPECT_GT(most, before);
}

}  // namespace
}  // namespace liesl::test::record_memory_test
