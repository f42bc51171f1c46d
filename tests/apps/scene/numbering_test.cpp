/// @file
/// Places of a beam by their numbers on another mesh (`beam.numbering`).

#include "apps/scene/numbering.hpp"

#include <gtest/gtest.h>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::numbering_test {
namespace {

/// The rod of 5 elements with a lug and a load at node 2, and others by number.
const std::string kScene =
    changed(changed(kGoodScene, "elements = 5",
                    "elements = 5, points = { lug = { on = \"node2\", at = [0.36, 0.1, 0] } }"),
            "[responses]\n",
            "[loads.hook]\nat = \"rod.node2\"\nforce = [0, 1, 0]\n\n[responses]\n"
            "place = { response = \"deflection\", of = \"rod\", at = \"node3\" }\n"
            "first = { response = \"section_force\", of = \"rod\", component = \"N\", element = 1, "
            "at = \"start\" }\n"
            "last = { response = \"section_force\", of = \"rod\", component = \"N\", element = 1, "
            "at = \"end\" }\n");

Scene read(const std::vector<std::string>& changes) {
  return read_scene(kScene, "scene.toml", changes);
}

const ResponseSpec& response(const Scene& scene, const std::string& name) {
  return *std::ranges::find(scene.responses, name, &ResponseSpec::name);
}

TEST(Numbering, KeepsPlacesOnAFinerMesh) {
  const Scene given = read({}),
              fine = read({"bodies.rod.beam.elements=20", "bodies.rod.beam.numbering=5"});
  const Mechanism &coarse = given.mechanism, &finer = fine.mechanism;
  ASSERT_EQ(finer.loads.size(), coarse.loads.size());
  for (std::size_t i = 0; i < finer.loads.size(); ++i)
    if (finer.loads[i].name == "hook") {
      EXPECT_EQ(finer.loads[i].port.node, 4 * coarse.loads[i].port.node);
    }
  EXPECT_EQ(finer.port("rod.lug")->node, 8);
  EXPECT_EQ(response(fine, "place").s, response(given, "place").s);
  EXPECT_EQ(response(fine, "first").element, 4);
  EXPECT_EQ(response(fine, "last").element, 7);
}

TEST(Numbering, OfAMeshWithoutThePlaceIsRefused) {
  const auto refusal = [](const std::string& text) {
    try {
      read_scene(text, "scene.toml", {"bodies.rod.beam.elements=7", "bodies.rod.beam.numbering=5"});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto with = [](const std::string& response) {
    return changed(kGoodScene, "[responses]\n", "[responses]\nat = " + response + "\n");
  };
  EXPECT_NE(refusal(kScene).find("no node 'node2'"), std::string::npos) << "of the lug";
  EXPECT_NE(refusal(with("{ response = \"position\", at = \"rod.node2\" }"))
                .find("body 'rod' has no port 'node2'"),
            std::string::npos);
  EXPECT_NE(refusal(with("{ response = \"section_force\", of = \"rod\", component = \"N\", "
                         "element = 1, at = \"end\" }"))
                .find("element 1 of the numbering of 'rod'"),
            std::string::npos);
  EXPECT_EQ(refusal(kGoodScene), "") << "names none by number";
}

TEST(Numbering, TheMiddleOfAnElementIsOneOfOddMultiples) {
  const auto middle = [](int elements) {
    toml::table root;
    root.insert(
        "bodies",
        toml::table{
            {"rod", toml::table{{"beam", toml::table{{"elements", elements}, {"numbering", 4}}}}}});
    return Numbering(root, "rod").element(1, ElementPlace::Middle);
  };
  EXPECT_EQ(middle(12), 4);
  EXPECT_FALSE(middle(8));
}

TEST(Numbering, OfSupportsAndOtherNames) {
  toml::table root;
  root.insert(
      "bodies",
      toml::table{{"rod", toml::table{{"beam", toml::table{{"elements", 8}, {"numbering", 4}}}}}});
  const Numbering rod(root, "rod"), other(root, "crank");
  EXPECT_EQ(rod.support("node3:xyz,rx"), "node6:xyz,rx");
  EXPECT_EQ(rod.port("end"), "end");
  EXPECT_EQ(rod.port("node_3"), "node_3");
  EXPECT_EQ(other.port("node3"), "node3");
}

}  // namespace
}  // namespace liesl::test::numbering_test
