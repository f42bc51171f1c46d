/// @file
/// Grids of meshed parts, doubled and halved.

#include "apps/tasks/part_grids.hpp"

#include <gtest/gtest.h>

#include "apps/input/document.hpp"
#include "apps/scene/load_scene.hpp"
#include "reference/places.hpp"

namespace liesl::test::part_grids_test {
namespace {

using Changes = std::vector<std::string>;

std::vector<PartGrid> grids(const char* scene, const Changes& changes = {}) {
  const std::string file = std::string(kDataDir) + "/scenes/" + scene;
  return part_grids({load_document(file).text, file, changes}, load_scene(file, changes).mechanism);
}

TEST(PartGrids, AreThoseOfTheScene) {
  const auto plates = grids("four_bar_plates.toml");
  ASSERT_EQ(plates.size(), 2u);
  EXPECT_EQ(plates[0].cells, (std::vector<long>{150, 15}));
  EXPECT_EQ(plates[1].cells, (std::vector<long>{110, 15}));
  EXPECT_EQ(plates[0].order, 1) << "with openings";
  EXPECT_TRUE(grids("pendulum.toml").empty());
  const auto changed = grids("four_bar_plates.toml", {"bodies.coupler.solid.mesh.cells=[80,8]"});
  EXPECT_EQ(changed[0].cells, (std::vector<long>{80, 8}));
}

TEST(PartGrids, DoubleAndHalveAllOrNone) {
  const std::vector<PartGrid> even = {{"a", {20, 4}}, {"b", {6, 2, 8}, 1}, {"of a file", {}}},
                              odd = {{"a", {20, 4}}, {"b", {6, 3, 8}}};
  EXPECT_EQ(grid_changes(even, 2), (Changes{"bodies.a.solid.mesh.cells=[40, 8]",
                                            "bodies.b.solid.mesh.cells=[12, 4, 16]"}));
  EXPECT_EQ(grid_changes(even, 0.5),
            (Changes{"bodies.a.solid.mesh.cells=[10, 2]", "bodies.b.solid.mesh.cells=[3, 1, 4]"}));
  EXPECT_TRUE(grid_changes(odd, 0.5).empty());
  EXPECT_EQ(grid_changes(odd, 2).size(), 2u);
}

TEST(PartGrids, HaveRoomForTheMostCells) {
  EXPECT_TRUE((PartGrid{"a", {500, 500}}.has_room()));
  EXPECT_FALSE((PartGrid{"a", {501, 500}}.has_room()));
  EXPECT_FALSE((PartGrid{"a", {51, 50, 50}}.has_room()));
}

}  // namespace
}  // namespace liesl::test::part_grids_test
