/// @file
/// `--verify`: errors beside what they are of; what has none is refused before any work.
#include "apps/program.hpp"

namespace liesl::test {
namespace {

class VerifyCommand : public Program {
 protected:
  /// The optimised rod, verified.
  Outcome optimise_rod(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {
        "optimize", study("slider_crank_rod"), "-o", results(), "--verify", "--no-report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Refused before any work.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.code, 2);
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(results()));
  }
};

/// With 64 elements a link the optimised rod bends 1.8 % more than with its 8.
TEST_F(VerifyCommand, SaysWhatTheMeshHidesOfALimit) {
  const Outcome o = optimise_rod();
  EXPECT_EQ(o.code, 0) << o.err;
  const double error = summary()["worst_constraint_error"];
  EXPECT_GT(error, 0.018 / 3);
  EXPECT_LT(error, 0.018 * 3);
  EXPECT_NE(o.out.find("limit bending is known to"), std::string::npos) << o.out << o.err;
}

TEST_F(VerifyCommand, NamesTheLimitsThatItLeavesOut) {
  const Outcome o =
      optimise_rod({"--set", "constraints.bending.treatment=functional", "--set", "cycle.max=1"});
  EXPECT_NE(o.code, 2) << o.err;
  EXPECT_NE(
      (o.out + o.err).find("not verified, being no largest value of a response: limit bending"),
      std::string::npos)
      << o.out << o.err;
}

TEST_F(VerifyCommand, RefusesFixedLoads) {
  expect_refused({"optimize", study("cantilever"), "-o", results(), "--verify"},
                 "no motion to verify");
}

/// The middle of an element is no place of another mesh.
TEST_F(VerifyCommand, SaysThatAPlaceNamedByNumberKeepsItsMesh) {
  std::string text = text_of(scene("slider_crank"));
  const std::string table = "[responses]\n";
  text.insert(text.find(table) + table.size(),
              "moment = { response = \"section_force\", of = \"rod\", at = \"mid\", "
              "component = \"Mz\" }\n");
  const Outcome o = run({"run", write("scene.toml", text), "-o", results(), "--verify"});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_NE(
      (o.out + o.err).find("leaves out beam rod: the scene names nodes or elements by number"),
      std::string::npos)
      << o.out << o.err;
}

TEST_F(VerifyCommand, RefusesModesBeforeTheyAreComputed) {
  expect_refused(
      {"run", scene("slider_crank"), "-o", results(), "--verify", "--set", "simulation.type=modes"},
      "natural frequencies have no responses to verify");
}

}  // namespace
}  // namespace liesl::test
