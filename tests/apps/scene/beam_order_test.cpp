/// @file
/// The default order of beam elements: 4 where an order 4 that is asked for is not refused, but 2
/// with damping and under a spread moment.
#include <gtest/gtest.h>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::beam_order_test {
namespace {

using Changes = std::vector<std::string>;

/// Order 2 or 4 of the rod; 0 if it is refused.
int order_of_rod(const std::string& text, const Changes& changes) {
  try {
    const Mechanism m = read_scene(text, "scene.toml", changes).mechanism;
    return std::get<BeamSpec>(m.bodies[static_cast<std::size_t>(m.body("rod"))].kind).order;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("of order 4"), std::string::npos) << error.what();
    return 0;
  }
}

const std::string kRod = "bodies.rod.beam.";
const std::string kDiagonal = "{ type = \"full\", stiffness = [1e6, 1e6, 1e6, 1e3, 1e3, 1e3], ";

const std::pair<Changes, int> kCases[] = {
    {{}, 4},
    {{"simulation.space=\"spatial\""}, 4},
    {{"simulation.update=\"r3so3\""}, 4},
    {{kRod + "section=[\"wall\", \"round\"]"}, 4},
    {{"loads.wind.force=[0, 0, 5]"}, 4},
    {{"loads.push.follower=true"}, 4},  // at a point
    {{"sections.wall=" + kDiagonal + "inertia = [3, 3, 3, 1e-3, 1e-3, 1e-3] }"}, 4},
    {{"simulation.formalism=\"r3so3\""}, 2},
    {{"simulation.formalism=\"classical\""}, 2},
    {{"simulation.formalism=\"floating\""}, 2},
    {{"simulation.formalism=\"rigid\""}, 2},
    {{"simulation.formalism=\"segments\""}, 2},
    {{kRod + "as=\"rigid\""}, 2},
    {{kRod + "as=\"modal\""}, 2},
    {{kRod + "as=\"segments\""}, 2},
    {{"loads.wind.follower=true"}, 4},
    {{"sections.wall=" + kDiagonal + "inertia = [3, 3, 2, 1e-3, 1e-3, 1e-3] }"}, 2},
    {{"sections.wall=" + kDiagonal +
      "inertia = [[3, 0, 0, 0, 0, -3e-3], [0, 3, 0, 0, 0, 0], [0, 0, 3, 3e-3, 0, 0], "
      "[0, 0, 3e-3, 1e-2, 0, 0], [0, 0, 0, 0, 5e-3, 0], [-3e-3, 0, 0, 0, 0, 5e-3]] }"},
     2},
};

/// Order 2 unless 4 is asked for.
const Changes kSecondByDefault[] = {{kRod + "damping=1e-5"}, {"loads.wind.moment=[0, 0, 1]"}};

/// By default, and where 4 and 2 are asked for.
void expect_orders(const Changes& changes, int by_default, int of_4) {
  const std::string text = changed(kGoodScene, ", follower = true", "");
  const auto with = [&changes](int asked) {
    Changes all = changes;
    all.push_back(kRod + "order=" + std::to_string(asked));
    return all;
  };
  const std::string what = changes.empty() ? "as it is" : changes[0];
  EXPECT_EQ(order_of_rod(text, changes), by_default) << what;
  EXPECT_EQ(order_of_rod(text, with(4)), of_4) << what;
  EXPECT_EQ(order_of_rod(text, with(2)), 2) << what;
}

TEST(BeamOrder, DefaultsToFourWhereFourIsNotRefused) {
  for (const auto& [changes, order] : kCases) expect_orders(changes, order, order == 4 ? 4 : 0);
  for (const Changes& changes : kSecondByDefault) expect_orders(changes, 2, 4);
}

/// A load over one beam is no matter of another.
TEST(BeamOrder, IsOfEachBeam) {
  const Mechanism m =
      read_scene(kGoodScene, "scene.toml", {"loads.wind.moment=[0, 0, 1]"}).mechanism;
  EXPECT_EQ(std::get<BeamSpec>(m.bodies[0].kind).order, 4);
  EXPECT_EQ(std::get<BeamSpec>(m.bodies[1].kind).order, 2) << "the wind turns it";
}

}  // namespace
}  // namespace liesl::test::beam_order_test
