/// @file
/// Files that a scene names, where the scene is written into another folder.

#include "apps/scene/scene_key.hpp"

#include <gtest/gtest.h>

#include "apps/input/rewrite.hpp"

namespace liesl::test::scene_key_test {
namespace {

constexpr const char* kScene = R"([bodies]
plate = { solid = { mesh = { file = "meshes/plate.msh" }, material = "steel" } }   # as measured
arm   = { solid = { matrices = { stiffness = "K.mtx", mass = "/there/M.mtx", nodes = "nodes.csv" } } }
bar   = { beam = { from = [0, 0, 0], to = [1, 0, 0] } }
)";

TEST(FileKeys, BecomeWholePathsAndTheRestStays) {
  const auto changes = whole_paths(kScene, "/home/scenes/part.toml",
                                   {"bodies.arm.solid.matrices.nodes=../nodes.csv"});
  EXPECT_EQ(changes, (std::vector<std::string>{
                         "bodies.arm.solid.matrices.stiffness='/home/scenes/K.mtx'",
                         "bodies.arm.solid.matrices.mass='/there/M.mtx'",
                         "bodies.arm.solid.matrices.nodes='/home/nodes.csv'",
                         "bodies.plate.solid.mesh.file='/home/scenes/meshes/plate.msh'"}));
  const std::string moved = rewrite_scene(kScene, changes);
  EXPECT_NE(moved.find("\"/home/scenes/meshes/plate.msh\""), std::string::npos) << moved;
  EXPECT_NE(moved.find("# as measured"), std::string::npos) << moved;
  EXPECT_EQ(moved.find("\"K.mtx\""), std::string::npos) << moved;
}

TEST(FileKeys, NoneChangesNothing) {
  EXPECT_TRUE(whole_paths("[bodies]\nbar = { beam = { to = [1, 0, 0] } }\n", "x.toml", {}).empty());
}

}  // namespace
}  // namespace liesl::test::scene_key_test
