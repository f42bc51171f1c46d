/// @file
/// `simulation.update`: every pair with a formalism and with a model of a body is read or refused
/// at its place; what is read is built.
#include <gtest/gtest.h>

#include <fstream>

#include "apps/good_scene.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "mbs/system/model.hpp"

namespace liesl::test::update_scene_test {
namespace {

/// The good scene with its load that follows left out, and keys of `[simulation]`; '@' is at the
/// value of `update`.
std::string scene_of(const std::string& formalism, const std::string& update) {
  const std::string dead =
      changed(kGoodScene, "force = [0, 3, 0], follower = true }", "force = [0, 3, 0] }");
  return changed(dead, "[simulation]",
                 "[simulation]\nformalism = \"" + formalism + "\"\nupdate = @\"" + update + "\"");
}

/// Is it refused at its '@' with these words, and is what is read built?
void expect(const std::string& marked, const std::vector<const char*>& refusal) {
  SCOPED_TRACE(marked);
  const MarkedText at(marked);
  const auto read = [](const auto& text, const auto& file) { read_scene(text, file); };
  if (!refusal.empty()) {
    expect_refused(at, "scene.toml", read, refusal);
    return;
  }
  const Mechanism m = read_scene(at.text, "scene.toml").mechanism;
  EXPECT_NO_THROW(Model<SE3>::build(m, {}));
}

TEST(UpdateScene, EveryPairWithAFormalism) {
  for (const char* formalism : {"se3", "r3so3", "rigid", "classical", "floating", "segments"})
    for (const char* update : {"formalism", "se3", "r3so3"}) {
      const std::string f = formalism, u = update;
      const bool taken = u == "formalism" || f == "se3" || f == "r3so3" || f == "rigid";
      expect(scene_of(f, u),
             taken ? std::vector<const char*>{}
                   : std::vector<const char*>{"'simulation.update'", update, "in the formalism",
                                              formalism, "formalism se3, r3so3 or rigid"});
    }
}

TEST(UpdateScene, EveryPairWithAModelOfABeam) {
  const std::pair<const char*, const char*> models[] = {
      {"rigid", ""}, {"modal", "has modes"}, {"segments", "is a chain of segments"}};
  for (const auto& [as, fault] : models)
    for (const char* update : {"formalism", "se3", "r3so3"}) {
      const std::string beam = std::string("elements = 4, as = \"") + as + "\" }";
      const bool taken = std::string(update) != "r3so3" || std::string(as) == "rigid";
      expect(changed(scene_of("se3", update), "elements = 4 }", beam),
             taken ? std::vector<const char*>{}
                   : std::vector<const char*>{"'simulation.update' = \"r3so3\"", "beam 'crank'",
                                              fault, "\"formalism\" or \"se3\""});
    }
}

class UpdateOfMeshes : public Program {};

/// By the program: exit code 2, the file or the change that is wrong, and what would do.
TEST_F(UpdateOfMeshes, IsRefusedWithPlaceAndHint) {
  const std::pair<const char*, const char*> models[] = {
      {"reduced", "part 'rod' has modes"}, {"continuum", "all nodes of the mesh of 'rod' move"}};
  for (const auto& [as, fault] : models) {
    std::string text = text_of(scene("meshed_slider_crank"));
    const std::string modes = text.substr(
        text.find("modes ="), text.find('\n', text.find("modes =")) - text.find("modes ="));
    if (std::string(as) == "continuum") text = changed(text, modes, "as = \"continuum\"");
    std::ofstream(dir_ / "scene.toml") << text;
    const std::string file = (dir_ / "scene.toml").string();
    EXPECT_EQ(run({"check", file, "--set", "simulation.update=\"se3\""}).code, 0) << as;
    const Outcome out = run({"check", file, "--set", "simulation.update=\"r3so3\""});
    EXPECT_EQ(out.code, 2) << as;
    for (const char* words : {"--set simulation.update=\"r3so3\": 'simulation.update' = \"r3so3\"",
                              fault, "expected \"formalism\" or \"se3\""})
      EXPECT_NE(out.err.find(words), std::string::npos) << out.err;
  }
}

}  // namespace
}  // namespace liesl::test::update_scene_test
