/// @file
/// Memory of long records: aligned, copied as vectors are, and untouched until it is used.
#include "mbs/linalg/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

namespace liesl::test::large_pages_test {
namespace {

using Values = std::vector<double, LargePages<double>>;

TEST(LargePages, HoldWhatVectorsHold) {
  for (const std::size_t size : {0u, 1u, 1000u, 262143u, 262144u, 600001u}) {
    Values values(size, 1.5);
    std::iota(values.begin(), values.end(), 0.0);
    Values grown = values;
    grown.resize(size + 300000);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(grown[i], values[i]) << size;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(grown.data()) % 64, 0u) << size;
  }
}

TEST(LargePages, NewElementsAreNotTouched) {
  Values values(4, 7.0);
  values.clear();
  values.resize(4);
  for (const double x : values) EXPECT_EQ(x, 7);
}

}  // namespace
}  // namespace liesl::test::large_pages_test
