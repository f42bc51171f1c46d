/// @file
/// `liesl sensitivity`: what it writes, against runs of neighbouring scenes; what it refuses.

#include <cmath>
#include <map>
#include <sstream>

#include "apps/program.hpp"

namespace liesl::test::sensitivity_test {
namespace {

/// Columns of a table of numbers by their headings.
std::map<std::string, std::vector<double>> columns(const fs::path& path) {
  std::istringstream lines(text_of(path));
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> names;
  std::istringstream heads(line);
  for (std::string name; std::getline(heads, name, ',');) names.push_back(name);
  std::map<std::string, std::vector<double>> out;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (const auto& name : names) {
      std::getline(cells, cell, ',');
      out[name].push_back(std::stod(cell));
    }
  }
  return out;
}

class Sensitivity : public Program {
 protected:
  Words command(const Words& more) const {
    Words words = {"sensitivity", "-q", "--set", "simulation.duration=0.02"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// A response of a run with a change, over the records.
  std::vector<double> response(const std::string& change, const std::string& column) const {
    const fs::path to = dir_ / "run";
    const Outcome o =
        run({"run", scene("slider_crank"), "-q", "-f", "-o", to, "--set",
             "simulation.duration=0.02", "--set", "simulation.tolerance=1e-10", "--set", change});
    EXPECT_EQ(o.code, 0) << o.err;
    return columns(to / "responses.csv").at(column);
  }
};

/// dy/dp in the table against central differences of two runs of the program.
TEST_F(Sensitivity, TableIsThatOfTwoRuns) {
  const std::map<std::string, std::pair<double, double>> parameters{
      {"sections.rod.diameter", {0.01, 1e-5}},
      {"materials.steel.rho", {7850, 5}},
      {"bodies.slider.rigid.mass", {0.2, 1e-3}},
      {"joints.motor.drive.rate", {150, 0.1}}};
  Words words = command({scene("slider_crank"), "-o", results()});
  for (const auto& [key, at] : parameters) {
    words.push_back("--by");
    words.push_back(key);
  }
  const Outcome o = run(words);
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(summary()["method"], "direct");
  EXPECT_EQ(summary()["status"], "done");
  const auto table = columns(results() / "sensitivities.csv");
  const std::map<std::string, std::string> units{{"sections.rod.diameter", "m/m"},
                                                 {"materials.steel.rho", "m/(kg/m^3)"},
                                                 {"bodies.slider.rigid.mass", "m/kg"},
                                                 {"joints.motor.drive.rate", "m/(rad/s or m/s)"}};
  for (const auto& [name, at] : parameters) {
    const std::string& key = name;
    const auto& [value, h] = at;
    const auto set = [&](double p) { return key + "=" + std::to_string(p); };
    const auto after = response(set(value + h), "bend.y [m]"),
               before = response(set(value - h), "bend.y [m]");
    const std::string heading = "bend.y by " + key + " [" + units.at(key) + "]";
    ASSERT_TRUE(table.contains(heading)) << heading;
    const auto& dy = table.at(heading);
    ASSERT_EQ(dy.size(), after.size());
    double size = 0, error = 0;
    for (std::size_t n = 0; n < dy.size(); ++n) {
      size = std::max(size, std::abs(dy[n]));
      error = std::max(error, std::abs(dy[n] - (after[n] - before[n]) / (2 * h)));
    }
    EXPECT_GT(size, 0) << key;
    EXPECT_LT(error, 1e-4 * size) << key;
  }
}

TEST_F(Sensitivity, DirectAndAdjointAgree) {
  const Words study_words = {study("slider_crank_rod"), "--functionals",
                             "peak,mean,rms,p=8,ks=100"};
  Words words = command(study_words);
  words.insert(words.end(), {"--method", "direct", "-o", results()});
  ASSERT_EQ(run(words).code, 0);
  const Json direct = summary();
  for (const char* file : {"gradients.csv", "sensitivities.csv", "sensitivities.h5",
                           "responses.csv", "plots/sensitivities.png", "plots/gradients.svg"})
    EXPECT_TRUE(fs::exists(results() / file)) << file;
  words = command(study_words);
  words.insert(words.end(), {"--method", "adjoint", "-f", "-o", results()});
  ASSERT_EQ(run(words).code, 0);
  const Json adjoint = summary();
  EXPECT_FALSE(fs::exists(results() / "sensitivities.csv")) << "dy/dp is not known";
  EXPECT_EQ(direct["method"], "direct");
  EXPECT_EQ(adjoint["method"], "adjoint");
  ASSERT_EQ(keys(direct["gradients"]), (std::set<std::string>{"bending", "bend", "slider_x"}));
  for (const auto& [response, functionals] : direct["gradients"].items())
    for (const auto& [functional, gradient] : functionals.items()) {
      const Json& other = adjoint["gradients"][response][functional];
      EXPECT_EQ(gradient["value"], other["value"]);
      double size = 0;
      for (const auto& [name, value] : gradient["by"].items())
        size = std::max(size, std::abs(value.get<double>()));
      EXPECT_EQ(gradient["by"].size(), 4u);
      for (const auto& [name, value] : gradient["by"].items())
        EXPECT_NEAR(value.get<double>(), other["by"][name].get<double>(), 1e-9 * size)
            << response << ", " << functional << " by " << name;
    }
}

/// An integral is the duration times the mean: by the duration the steps are longer, too.
TEST_F(Sensitivity, IntegralsGrowWithTheDuration) {
  for (const char* method : {"direct", "adjoint"}) {
    ASSERT_EQ(run({"sensitivity", study("robot_codesign"), "-q", "-f", "-o", results(), "--method",
                   method, "--functionals", "integral,mean", "--set", "simulation.step=4e-3"})
                  .code,
              0);
    const Json s = summary();
    for (const auto& [name, parameter] : s["parameters"].items()) {
      const double grows = name == "duration", T = s["parameters"]["duration"]["value"];
      for (const auto& [response, of] : s["gradients"].items()) {
        const double mean = of["mean"]["value"], by_mean = of["mean"]["by"][name],
                     by_integral = of["integral"]["by"][name];
        EXPECT_NEAR(by_integral, grows * mean + T * by_mean,
                    1e-9 * (std::abs(mean) + T * std::abs(by_mean)))
            << response << " by " << name << ", " << method;
      }
    }
  }
}

/// By the duration of a scene its drives are stretched, whatever their kind.
TEST_F(Sensitivity, DurationOfAScene) {
  for (const char* name : {"two_link_robot_path", "slider_crank", "four_bar"}) {
    SCOPED_TRACE(name);
    const Outcome o = run({"sensitivity", scene(name), "--by", "simulation.duration", "--check",
                           "--functionals", "peak,rms"});
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    EXPECT_NE(o.out.find(" 0 wrong"), std::string::npos) << o.out;
  }
}

TEST_F(Sensitivity, CheckPrintsTheErrorAndTheSlope) {
  const Outcome o = run({"sensitivity", scene("slider_crank"), "--by", "sections.rod.diameter",
                         "--check", "--set", "simulation.duration=0.02"});
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("bend, rms"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("slope"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("8 derivatives checked, 0 wrong"), std::string::npos) << o.out;
}

/// By the length of a chain that bends, whatever the number of its segments: its end goes with the
/// points beside it, along the axes of the first one. (It went along its own, and strained the last
/// segment: 2 % off with 128 of them.)
TEST_F(Sensitivity, ByTheLengthOfManySegments) {
  for (const char* elements : {"16", "128"}) {
    const Outcome o =
        run({"sensitivity", study("sensitivity_pendulum"), "--check", "--fits", "--functionals",
             "rms", "--by", "bodies.beam.beam.to.0", "--set", "scene.simulation.formalism=segments",
             "--set", std::string("scene.bodies.beam.beam.elements=") + elements, "--set",
             "simulation.duration=0.25"});
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    const auto row = o.out.find("bend, rms");
    ASSERT_NE(row, std::string::npos) << o.out;
    std::istringstream line(o.out.substr(row + 9));
    std::string by, slope;
    double best = 1, step = 0, extrapolated = 1, fitted = 1;
    line >> by >> best >> step >> slope >> extrapolated >> fitted;
    EXPECT_LT(best, 1e-7) << o.out;
    EXPECT_LT(fitted, 1e-7) << o.out;
  }
}

/// Polynomials fitted to 120 differences stand beside the best of eight.
TEST_F(Sensitivity, CheckByFits) {
  const Outcome o =
      run({"sensitivity", scene("slider_crank"), "--by", "sections.rod.diameter", "--check",
           "--fits", "--set", "simulation.duration=0.005", "--functionals", "rms"});
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("fitted"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find(" derivatives checked, 0 wrong"), std::string::npos) << o.out;
  EXPECT_EQ(
      run({"sensitivity", scene("slider_crank"), "--by", "sections.rod.diameter", "--fits"}).code,
      2);
}

/// Error of the worst row of `--check`, which is the first.
double worst_error(const std::string& out) {
  std::istringstream lines(out);
  std::string line;
  for (int i = 0; i < 2; ++i) std::getline(lines, line);
  std::istringstream row(line.substr(std::min(line.size(), line.find(", "))));
  std::string comma, functional, by;
  double error = 1;
  row >> comma >> functional >> by >> error;
  return error;
}

/// Files of the kind: psi = int g dt by lengths, too, against differences of whole simulations:
/// within 1e-7 at the best step, every row. The end of the slider-crank's rod belongs to two
/// parameters.
TEST_F(Sensitivity, FilesAreThatOfDifferences) {
  for (const char* name :
       {"sensitivity_pendulum", "sensitivity_slider_crank", "sensitivity_four_bar"}) {
    SCOPED_TRACE(name);
    const Outcome check = run({"sensitivity", study(name), "--check"});
    EXPECT_EQ(check.code, 0) << check.out << check.err;
    EXPECT_NE(check.out.find(" 0 wrong"), std::string::npos) << check.out;
    EXPECT_LT(worst_error(check.out), 1e-7) << check.out;
    ASSERT_EQ(run({"sensitivity", study(name), "-q", "-f", "-o", results()}).code, 0);
    const Json s = summary();
    for (const auto& [response, functionals] : s["gradients"].items()) {
      EXPECT_EQ(keys(functionals), (std::set<std::string>{"integral", "rms"}));
      for (const auto& [parameter, by] : functionals["rms"]["by"].items())
        EXPECT_NE(by.get<double>(), 0) << response << " by " << parameter;
    }
  }
}

/// The command line goes before the file; what is wrong in a file is said with its place.
TEST_F(Sensitivity, FilesAreReadAndChecked) {
  const fs::path file = study("sensitivity_pendulum");
  EXPECT_EQ(run({"check", file}).out.find("a good sensitivity of 2 responses by 4 parameters"),
            file.string().size() + 2);
  ASSERT_EQ(run({"sensitivity", file, "-q", "-o", results(), "--set", "simulation.duration=0.02",
                 "--by", "materials.rubber.E", "--functionals", "peak", "--method", "adjoint"})
                .code,
            0);
  EXPECT_EQ(summary()["method"], "adjoint");
  EXPECT_EQ(keys(summary()["gradients"]["tip"]), (std::set<std::string>{"peak"}));
  EXPECT_EQ(keys(summary()["gradients"]["tip"]["peak"]["by"]),
            (std::set<std::string>{"materials.rubber.E"}));
  const auto refused = [&](const std::string& change, const char* why) {
    const Outcome o = run({"sensitivity", file, "-o", dir_ / "none", "--set", change});
    EXPECT_EQ(o.code, 2) << change;
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
  };
  refused("functionals=[\"integrall\"]", "did you mean 'integral'?");
  refused("method=forward", "'method'");
  refused("by=[\"bodies.beam.beam.to.7\"]", "bodies.beam.beam.to.7");
  refused("byy=1", "byy");
  EXPECT_EQ(run({"run", file, "-o", dir_ / "none"}).code, 2);

  std::string text = text_of(file);
  const auto change = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change("../scenes/", (kData / "scenes/").string());
  change("\"simulation.duration\" = 0.5",
         "\"simulation.durations\" = 0.5, \"simulation.step\" = -1");
  std::ofstream(dir_ / "set.toml") << text;
  const Outcome o = run({"check", dir_ / "set.toml"});
  EXPECT_EQ(o.code, 2);
  for (const char* said : {"set.toml:6:34: unknown key 'simulation.durations'",
                           "set.toml:6:59: 'simulation.step' is out of range: -1"})
    EXPECT_NE(o.err.find(said), std::string::npos) << o.err;
}

TEST_F(Sensitivity, RefusesWhatItCannotDo) {
  const auto refused = [&](const Words& more, const char* why) {
    Words words = command({"-o", results()});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome o = run(words);
    EXPECT_EQ(o.code, 2) << why;
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(results()));
  };
  const std::string rod = scene("slider_crank");
  refused({rod}, "by which parameters?");
  refused({rod, "--by", "sections.rod.diametr"}, "did you mean 'diameter'?");
  refused({rod, "--by", "sections.rod.type"}, "'sections.rod.type' is no number");
  refused({rod, "--by", "bodies.crank.beam.damping"}, "is not written in the scene");
  refused({rod, "--by", "bodies.rod.beam.elements"},
          "--by bodies.rod.beam.elements: values next to its own are refused");
  refused({rod, "--by", "simulation.step"}, "changes nothing that has a derivative");
  refused({rod, "--by", "bodies.crank.beam.to.0"}, "opens joints: bodies were moved by");
  refused({rod, "--by", "bodies.rod.beam.to.0+bodies.slider.rigid.mass"}, "numbers of one unit");
  refused({rod, "--by", "simulation.duration+simulation.step"}, "the duration by itself");
  refused({scene("flying_beam"), "--by", "simulation.duration"},
          "load 'throw' follows time, and not the duration");
  refused({rod, "--by", "sections.rod.diameter", "--functionals", "peek"}, "did you mean 'peak'?");
  refused({rod, "--by", "sections.rod.diameter", "--functionals", "at=99"},
          "--functionals at=99: the motion ends at");
  refused({rod, "--by", "sections.rod.diameter", "--set", "simulation.type=static"},
          "this scene has none");
  refused({rod, "--by", "sections.rod.diameter", "--set", "simulation.constraints=augmented",
           "--set", "simulation.space=spatial", "--set", "simulation.formalism=rigid"},
          "no sensitivities where augmented penalties share the forces");
  refused({study("slider_crank_rod"), "--by", "sections.rod.diameter"}, "by its variables");
  refused({study("batch_rod")}, "this is a batch");
}

/// A flap whose tip is pushed, less a feature.
std::string flap_without(const std::string& hole) {
  return R"(name = "flap"
[materials]
rubber = { E = 1e6, nu = 0.3, rho = 1000 }

[bodies.flap.solid]
mesh = { from = [0, 0], to = [0.3, 0.03], cells = [40, 4] }
material = "rubber"
thickness = 0.02

[bodies.flap.solid.interfaces]
root = { set = "x_min" }
tip = { set = "x_max" }

[joints]
clamp = { fixed = ["ground", "flap.root"] }

[loads]
push = { at = "flap.tip", force = [0, 0.1, 0] }

[simulation]
duration = 0.04
step = 1e-3

[responses]
tip = { response = "position", at = "flap.tip" }

[bodies.flap.solid.outline]
plate = { type = "half_space", x = 1 }
hole = )" +
         hole + "\nall = { type = \"difference\", of = [\"plate\", \"hole\"] }\n";
}

/// A flap with a hole by the radius and the place of that, as a continuum and reduced.
TEST_F(Sensitivity, OfAnOutlineByItsKeysIsThatOfDifferences) {
  const std::string circle = "{ type = \"circle\", x = 0.101, y = 0.0145, radius = 0.0092 }";
  const fs::path flap = write("flap.toml", flap_without(circle));
  const std::string solid = "bodies.flap.solid.", hole = solid + "outline.hole.";
  for (const std::string as : {"continuum", "reduced"}) {
    const Outcome o =
        run({"sensitivity", flap, "--by", hole + "radius", "--by", hole + "x", "--functionals",
             "rms", "--check", "--set", solid + "as=" + as, "--set", solid + "damping=1e-3"});
    EXPECT_EQ(o.code, 0) << o.out << o.err;
  }
}

/// An edge on a grid line has another gradient on its other side: said without --check, too; a part
/// of a cell beside it, nothing is.
TEST_F(Sensitivity, OfAnEdgeOnAGridLineSaysThatItIsOneSided) {
  const auto notes = [this](const std::string& x) {
    const std::string slot =
        "{ type = \"rectangle\", x = " + x + ", y = 0.015, width = 0.03, height = 0.009 }";
    const fs::path flap = write("flap.toml", flap_without(slot));
    const std::string hole = "bodies.flap.solid.outline.hole.";
    const Outcome o =
        run({"sensitivity", flap, "--by", hole + "width", "--by", hole + "height", "-o", results(),
             "--force", "--set", "simulation.duration=0.004", "--set", "simulation.step=1e-4"});
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(o.out.find("lie on grid lines") != std::string::npos, x == "0.105") << o.out;
    std::string all;
    const Json warnings = summary()["warnings"];
    for (const std::string note : warnings) all += note + "\n";
    return all;
  };
  EXPECT_NE(
      notes("0.105").find("edges of the part 'flap' that bodies.flap.solid.outline.hole.width "
                          "moves lie on grid lines, where the fractions of cells have a kink "
                          "and gradients hold to one side only"),
      std::string::npos);
  EXPECT_EQ(notes("0.1065").find("grid lines"), std::string::npos);
}

/// Two modes of a meshed part follow its outline: with modes that are kept, "tilt" is off by 4e-2
/// and the elongation by 8e-3. The force in the wrist hardly follows it (1e-2 of itself over the
/// range), and two kernels of OpenBLAS give it with 1e-11 to 1e-9 of itself apart, so that its
/// differences come within 2e-6 to 2e-5 of the derivative: it may be left unjudged for round-off.
TEST_F(Sensitivity, OfAnOutlineIsThatOfDifferencesWithFewModes) {
  const fs::path rod = write("rod.toml", "scene = \"" + scene("connecting_rod") + R"("
[set]
"bodies.rod.solid.mesh.cells" = [40, 8]
"bodies.rod.solid.modes" = 2
"simulation.duration" = 0.008
"simulation.step" = 5e-5
[design.height]
of = "rod"
parameters = ["plate.height", "plate.fillet"]
factors = [1, 0.5]
bounds = [0.032, 0.044]
start = 0.0412
[objective]
of = "rod"
[constraints]
elongation = { response = "elongation", between = ["rod.big_end", "rod.small_end"], limit = 1e-3 }
)");
  const Outcome o = run({"optimize", rod, "--check-derivatives"});
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  const auto motion = o.out.find("the motion");
  ASSERT_NE(motion, std::string::npos) << o.out;
  EXPECT_NE(o.out.find("4 derivatives checked, 0 wrong", motion), std::string::npos) << o.out;
  EXPECT_EQ(o.out.find("kink, not judged", motion), std::string::npos) << o.out;
  for (const char* judged : {"elongation, peak", "tilt, peak"}) {
    const auto line = o.out.find(judged, motion);
    ASSERT_NE(line, std::string::npos) << o.out;
    const std::string row = o.out.substr(line, o.out.find('\n', line) - line);
    EXPECT_EQ(row.find("not judged"), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace liesl::test::sensitivity_test
