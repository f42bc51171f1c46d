/// Series of bodies by blocks of records, to a sink, against those that the results keep.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"

namespace liesl::test::body_series_test {
namespace {

using output::BodyResult;
using output::kBodySeries;

/// A chain of a flexible and a rigid body. @param simulation keys of it
Scene scene(const std::string& simulation) {
  return read_scene(R"toml(
gravity = [0, -9.81, 0]
[materials]
steel = { E = 2e11, nu = 0.3, rho = 7800 }
[sections]
flat = { type = "rectangle", width = 0.02, height = 0.005 }
[bodies]
arm = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "flat", material = "steel", elements = 12 } }
end = { rigid = { mass = 0.1, at = [1, 0, 0], inertia = [1e-4, 1e-4, 1e-4] } }
[joints]
hinge = { revolute = ["ground", "arm.start"], axis = [0, 0, 1] }
hold = { fixed = ["arm.end", "end.origin"] }
[responses]
speed = { response = "velocity", at = "arm.end" }
[simulation]
duration = 0.4
step = 1e-3
)toml" + simulation,
                    "scene.toml");
}

/// Puts the blocks together again.
class Whole final : public output::BodySink {
 public:
  void put(const std::vector<BodyResult>& block, std::size_t first, std::size_t count,
           std::size_t n) override {
    EXPECT_EQ(first, records);
    if (first == 0) bodies.resize(block.size());
    for (std::size_t b = 0; b < block.size(); ++b)
      for (const auto series : kBodySeries) {
        const auto& from = block[b].*series;
        EXPECT_EQ(from.size() % count, 0u);
        (bodies[b].*series).insert((bodies[b].*series).end(), from.begin(), from.end());
      }
    records += count;
    ++blocks;
    expected = n;
  }

  std::vector<BodyResult> bodies;
  std::size_t records = 0, expected = 0;
  int blocks = 0;
};

TEST(BodySeries, BlocksAreTheWhole) {
  for (const char* keys :
       {"", "space = \"spatial\"\n", "formalism = \"rigid\"\n", "output_every = 50\n"}) {
    const Scene read = scene(keys);
    const ChosenSpace space = choose_space(read);
    const output::Results all = run_task(read, space).results;
    Whole whole;
    const output::Results few = run_task(read, space, {}, &whole).results;
    ASSERT_EQ(whole.records, all.times.size()) << keys;
    EXPECT_EQ(whole.expected, all.times.size());
    EXPECT_EQ(whole.blocks > 1, all.times.size() > 100) << keys;
    EXPECT_EQ(few.times, all.times);
    EXPECT_TRUE(all.kept.empty());
    const int records = static_cast<int>(all.times.size());
    ASSERT_EQ(few.peaks.size(), 1u);
    EXPECT_GT(few.peaks[0], 0);
    EXPECT_LT(few.peaks[0], records);
    EXPECT_NEAR(few.times[static_cast<std::size_t>(few.peaks[0])], few.responses[0].peak->at,
                keys[0] == 'o' ? 0.025 : 1e-9);
    EXPECT_EQ(few.kept, output::frame_records(all, output::kFrames));
    EXPECT_TRUE(std::ranges::count(few.kept, few.peaks[0]) == 1);
    EXPECT_EQ(few.bodies[1].path.size(),
              3u * static_cast<std::size_t>(std::min(records, output::kPathPoints)));
    ASSERT_EQ(whole.bodies.size(), 2u);
    for (std::size_t b = 0; b < all.bodies.size(); ++b) {
      EXPECT_FALSE(all.bodies[b].positions.empty());
      EXPECT_EQ(few.bodies[b].largest_stress, all.bodies[b].largest_stress);
      for (const auto series : kBodySeries) {
        const auto &expected = all.bodies[b].*series, &kept = few.bodies[b].*series;
        EXPECT_EQ(whole.bodies[b].*series, expected) << keys;
        const std::size_t size = expected.size() / all.times.size();
        ASSERT_EQ(kept.size(), size * few.kept.size());
        for (const int record : few.kept)
          EXPECT_TRUE(std::equal(kept.begin() + static_cast<long>(few.row(record) * size),
                                 kept.begin() + static_cast<long>((few.row(record) + 1) * size),
                                 expected.begin() + static_cast<long>(size) * record));
      }
    }
    const auto& stresses = all.bodies[0].stresses;
    EXPECT_EQ(all.bodies[0].largest_stress, *std::max_element(stresses.begin(), stresses.end()));
  }
}

/// Blocks are taken beside the making of the next: what fails then is heard of.
TEST(BodySeries, AFailingSinkStopsIt) {
  class Full final : public output::BodySink {
   public:
    void put(const std::vector<BodyResult>&, std::size_t first, std::size_t, std::size_t) override {
      if (first >= from) throw std::runtime_error("no space left");
    }
    std::size_t from = 0;
  };
  const Scene read = scene("");
  const ChosenSpace space = choose_space(read);
  for (const std::size_t from : {0, 100, 390}) {
    Full sink;
    sink.from = from;
    EXPECT_THROW(run_task(read, space, {}, &sink), std::runtime_error) << from;
  }
}

}  // namespace
}  // namespace liesl::test::body_series_test
