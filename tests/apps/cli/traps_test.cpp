/// @file
/// What would be wrong without a word, and is a figure: a value that must not depend on what is
/// recorded, on axes, on space. What is said in words is in tests/traps/traps.toml.
#include <cmath>

#include "apps/program.hpp"

namespace liesl::test::traps_test {
namespace {

const std::string kMaterials = R"toml(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
thick = { type = "circle", diameter = 0.02 }
thin = { type = "circle", diameter = 0.01 }
flat = { type = "rectangle", width = 0.04, height = 0.005 }
)toml";

/// DRIVE, GUIDE and ROD are replaced.
const std::string kSliderCrank = R"toml(gravity = [0, -9.81, 0]
[bodies]
crank = { beam = { from = [0, 0, 0], to = [0.15, 0, 0], section = "thick", material = "steel", elements = 4 } }
rod = { beam = { from = [0.15, 0, 0], to = [0.45, 0, 0], section = "thin", material = "steel", elements = 4, ROD } }
slider = { rigid = { at = [0.45, 0, 0], mass = 0.2, inertia = [1e-4, 1e-4, 1e-4] } }
[joints]
motor = { revolute = ["ground", "crank.start"], drive = { DRIVE } }
pin = { revolute = ["crank.end", "rod.start"] }
wrist = { revolute = ["rod.end", "slider.origin"] }
guide = { prismatic = ["ground", "slider.origin"], axis = [1, 0, 0] GUIDE }
[simulation]
duration = 0.02
step = 1e-4
[responses]
bend = { response = "deflection", of = "rod" }
x = { response = "position", at = "slider.origin", axis = [1, 0, 0] }
)toml";

std::string slider_crank(const std::string& drive, const std::string& guide = "",
                         const std::string& rod = "damping = 0") {
  std::string text = kSliderCrank;
  for (const auto& [key, value] :
       {std::pair{"DRIVE", drive}, std::pair{"GUIDE", guide}, std::pair{"ROD", rod}})
    text.replace(text.find(key), std::string(key).size(), value);
  return text + kMaterials;
}

/// A right-angle frame, weak out of its plane.
const std::string kFrame = R"toml([sections]
strip = { type = "rectangle", width = 0.02, height = 0.005 }
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies]
leg1 = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "strip", material = "steel", elements = 16 } }
leg2 = { beam = { from = [1, 0, 0], to = [1, -1, 0], section = "strip", material = "steel", elements = 16 } }
[joints]
clamp = { fixed = ["ground", "leg1.start"] }
corner = { fixed = ["leg1.end", "leg2.start"] }
[simulation]
type = "modes"
modes = 4
)toml";

class TrapFigures : public Program {
 protected:
  Outcome run_scene(const std::string& text, const Words& set = {}) {
    Words words{"run", write("scene.toml", text), "-o", results(), "--force"};
    for (const auto& s : set) words.insert(words.end(), {"--set", s});
    fs::remove_all(results());
    const Outcome out = run(words);
    if (fs::exists(results() / "summary.json")) summary_ = summary();
    return out;
  }
  Json summary_ = Json::object();
};

/// A plane frame of flat bars, weak out of its plane, that its own plane sees as stable.
TEST_F(TrapFigures, BucklingOutOfThePlaneIsSeen) {
  const std::string portal = R"toml([bodies]
left = { beam = { from = [0, 0, 0], to = [0, 1, 0], section = "flat", material = "steel", elements = 8 } }
top = { beam = { from = [0, 1, 0], to = [1, 1, 0], section = "flat", material = "steel", elements = 8 } }
right = { beam = { from = [1, 0, 0], to = [1, 1, 0], section = "flat", material = "steel", elements = 8 } }
[joints]
a = { fixed = ["ground", "left.start"] }
b = { fixed = ["ground", "right.start"] }
c = { fixed = ["left.end", "top.start"] }
d = { fixed = ["top.end", "right.end"] }
[loads]
p1 = { at = "left.end", force = [0, -1, 0], scale = 2000 }
p2 = { at = "right.end", force = [0, -1, 0], scale = 2000 }
[simulation]
type = "static"
critical = true
)toml" + kMaterials;
  EXPECT_EQ(run_scene(portal).code, 0);
  EXPECT_EQ(summary_["space"], "spatial");
  ASSERT_FALSE(summary_["critical_loads"].empty());
  EXPECT_NEAR(summary_["critical_loads"][0]["load"].get<double>(), 0.108, 0.001);
  run_scene(portal, {"simulation.space=planar"});
  EXPECT_TRUE(!summary_.contains("critical_loads") ||
              summary_["critical_loads"][0]["load"].get<double>() > 0.9);
}

/// A right-angle frame of strips vibrates softly out of its plane.
TEST_F(TrapFigures, ModesOutOfThePlaneAreSeen) {
  const auto first = [&](const char* space) {
    run_scene(kFrame, {std::string("simulation.space=") + space});
    return summary_["frequencies_hz"][0].get<double>();
  };
  EXPECT_NEAR(first("auto"), 1.46, 0.01);
  EXPECT_EQ(first("auto"), first("spatial"));
  EXPECT_NEAR(first("planar"), 5.57, 0.01);
}

/// The columns of a deflection are the same in the plane and in space.
TEST_F(TrapFigures, ColumnsKeepTheirNamesInSpace) {
  const std::string text = slider_crank("rate = 100, ramp = 0.01");
  const auto head = [&](const char* space) {
    run_scene(text, {std::string("simulation.space=") + space});
    const std::string table = text_of(results() / "responses.csv");
    return table.substr(0, table.find('\n'));
  };
  EXPECT_EQ(head("planar"), "time [s],bend.y [m],x [m]");
  EXPECT_EQ(head("spatial"), "time [s],bend.y [m],bend.z [m],x [m]");
}

/// Largest values do not depend on what is recorded.
TEST_F(TrapFigures, PeaksAreThoseOfEveryStep) {
  const std::string text = slider_crank("rate = 300, ramp = 0.005");
  run_scene(text);
  const Json all = summary_["responses"]["bend"];
  run_scene(text, {"simulation.output_every=25"});
  EXPECT_EQ(summary_["responses"]["bend"]["max_abs"], all["max_abs"]);
  EXPECT_EQ(summary_["responses"]["bend"]["at_time"], all["at_time"]);
  EXPECT_EQ(summary_["responses"]["bend"]["axes"], "y");
}

/// Inertial axes of a displacement are those of the scene, whatever the beam's own.
TEST_F(TrapFigures, DisplacementIsInTheAxesAskedFor) {
  const std::string tower = R"toml([bodies]
b = { beam = { from = [0, 0, 0], to = [0, 0, 1], section = "thick", material = "steel", elements = 8 } }
[joints]
j = { fixed = ["ground", "b.start"] }
[loads]
f = { at = "b.end", force = [10, 0, 0] }
[simulation]
type = "static"
[responses]
here = { response = "displacement", at = "b.end" }
there = { response = "displacement", at = "b.end", in = "inertial" }
)toml" + kMaterials;
  run_scene(tower);
  const double exact = 10 / (3 * 210e9 * M_PI * std::pow(0.02, 4) / 64);
  const auto& responses = summary_["responses"];
  EXPECT_NEAR(responses["there"]["final"][0].get<double>() / exact, 1, 0.01);
  EXPECT_NEAR(responses["here"]["final"][0].get<double>(), 0, 1e-5);
  EXPECT_NEAR(responses["here"]["max_abs"].get<double>(),
              responses["there"]["max_abs"].get<double>(), 1e-15);
}

/// A strip bent far with much damping takes its steps whole.
TEST_F(TrapFigures, DampingInLargeBendingCostsNoSteps) {
  const std::string strip = R"toml([bodies]
bar = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "q", material = "steel", elements = 32, damping = 2e-3 } }
[joints]
j = { fixed = ["ground", "bar.start"] }
[loads]
s = { at = "bar.end", force = [0, 1200, 0], scale = "(t<1)?t:1" }
[simulation]
duration = 2
step = 2e-3
[responses]
tip = { response = "position", at = "bar.end" }
)toml" + kMaterials + "q = { type = \"rectangle\", width = 0.01, height = 0.01 }\n";
  EXPECT_EQ(run_scene(strip).code, 0);
  EXPECT_EQ(summary_["steps"], 1000);
  EXPECT_EQ(summary_["rejected_steps"], 0);
  EXPECT_LT(summary_["newton_iterations"], 5000);
  EXPECT_GT(summary_["responses"]["tip"]["final"][1], 0.7);  // bent far
}

/// Edges on lines of the grid: the check of derivatives moves off and says so, and so does a run.
TEST_F(TrapFigures, EdgesOnGridLinesAreNamed) {
  write("scene.toml", R"toml([bodies.plate.solid]
mesh = { from = [0, -0.04], to = [0.16, 0.04], cells = [16, 8] }
material = "steel"
thickness = 0.01
ersatz = { ratio = 1e-3 }
interfaces = { wall = { set = "x_min" }, tip = { set = "x_max", tie = "averaged" } }
[bodies.plate.solid.outline]
bar = { type = "rectangle", x = 0.1, width = 0.4, height = 0.06 }
)toml" + kMaterials);
  const std::string study = write("study.toml", R"toml(scene = "scene.toml"
[design]
height = { of = "plate", parameters = "bar.height", bounds = [0.03, 0.078] }
[objective]
minimize = "mass"
of = "plate"
[part_limits]
soft = { of = "plate", quantity = "compliance", limit = 0.02 }
[loads]
f = { at = "plate.tip", force = [0, 1000, 0] }
)toml");
  const Words shifted{"--set", "design.height.start=0.0612"};
  const auto with = [](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Words check{"optimize", study, "--check-derivatives"};
  const Outcome on_line = run(check), off_line = run(with(check, shifted));
  EXPECT_EQ(on_line.code, 0) << on_line.out << on_line.err;
  EXPECT_NE(on_line.out.find("along height:"), std::string::npos) << on_line.out;
  EXPECT_NE(on_line.out.find("checked, 0 wrong"), std::string::npos) << on_line.out;
  EXPECT_EQ(off_line.code, 0) << off_line.out << off_line.err;
  EXPECT_EQ(off_line.out.find("kink"), std::string::npos) << off_line.out;
  const Words optimize{"optimize", study, "-o", results(), "--force"};
  const char* words = "edges of the part 'plate' that height moves lie on grid lines at the start";
  run(optimize);
  EXPECT_NE(summary()["warnings"].dump().find(words), std::string::npos) << summary()["warnings"];
  run(with(optimize, shifted));
  EXPECT_EQ(summary()["warnings"].dump().find(words), std::string::npos);
}

}  // namespace
}  // namespace liesl::test::traps_test
