/// @file
/// What `liesl optimize` prints: shares with their sign and unit, columns under their headings,
/// each thing once.
#include "apps/cli/optimize_terminal.hpp"

#include <cmath>

#include "apps/program.hpp"

namespace liesl::test::optimize_terminal_test {
namespace {

using Lines = std::vector<std::string>;

template <class Print>
Lines printed(const Print& print) {
  testing::internal::CaptureStdout();
  print();
  std::istringstream text(testing::internal::GetCapturedStdout());
  Lines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

/// Ends of the columns of a heading, whose names are two spaces or more apart.
std::vector<std::size_t> ends_of(const std::string& heading) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < heading.size(); ++i)
    if (heading[i] != ' ' && heading.substr(i + 1, 2).find_first_not_of(' ') == std::string::npos)
      ends.push_back(i + 1);
  return ends;
}

/// In cycles that are light and heavy, within the limits and far from them, first and last.
Lines cycles(SolidResponse objective) {
  return printed([objective] {
    const double masses[] = {0.242913, 1.56, 12345.678, 1.2e-5};
    const double worst[] = {-0.00052, 0.26, 123.4, 1e-9};
    const std::optional<double> changes[] = {std::nullopt, 0.057, 12.0, 3.6e-3};
    for (int i = 0; i < 4; ++i) {
      Cycle c;
      c.number = i == 3 ? 1234 : i + 1;
      c.mass = masses[i];
      c.objective = -1.234567e-12 * masses[i];
      c.worst = worst[i];
      c.load_change = changes[i];
      c.load_cases = i == 3 ? 0 : 107;
      c.iterations = 11;
      print_cycle(c, objective, false);
    }
  });
}

TEST(OptimizeTerminal, SharesHaveASignAndAUnitAndNoMoreDigitsThanTheyTell) {
  const Lines lines = cycles(SolidResponse::Mass);
  ASSERT_EQ(lines.size(), 5u);
  const Lines worst = {"-0.052 %", "+26 %", "+12340 %", "0 %"},
              change = {"-", "5.7 %", "1200 %", "0.36 %"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lines[i + 1].substr(20, 14), std::string(14 - worst[i].size(), ' ') + worst[i]);
    EXPECT_EQ(lines[i + 1].substr(34, 14), std::string(14 - change[i].size(), ' ') + change[i]);
  }
}

TEST(OptimizeTerminal, ColumnsEndWhereTheirHeadingsEnd) {
  for (const auto objective :
       {SolidResponse::Mass, SolidResponse::Output, SolidResponse::Compliance,
        SolidResponse::Stress, SolidResponse::Frequency}) {
    const Lines lines = cycles(objective);
    ASSERT_EQ(lines.size(), 5u);
    const auto ends = ends_of(lines[0]);
    EXPECT_EQ(ends.size(), objective == SolidResponse::Mass ? 6u : 7u) << lines[0];
    for (std::size_t i = 1; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i].size(), lines[0].size()) << joined(lines);
      for (const std::size_t end : ends) {
        EXPECT_NE(lines[i].substr(end - 1, 1), " ") << joined(lines);
        EXPECT_TRUE(end == lines[i].size() || lines[i][end] == ' ') << joined(lines);
      }
    }
  }
}

output::OptimizeSummary summary_of(const std::string& reason, const std::string& kkt) {
  output::OptimizeSummary s;
  s.name = "rod";
  s.status = "optimal";
  s.reason = reason;
  s.mass_initial = 2;
  s.mass_final = 2.52;
  s.worst_constraint = -3e-5;
  s.wall_s = 0.567;
  s.more = {{"kkt", kkt}, {"worst_constraint_error", 7.5e-4}, {"prices", {{"bending", 0.288}}}};
  s.design = {{"d", 0.01146, 0.00931886, 0.004, 0.02}, {"length_of_it[10]", 12.5, 1234.5, 1, 2000}};
  s.warnings = {"the first note", "the second note"};
  s.history.resize(4);
  return s;
}

TEST(OptimizeTerminal, EndSaysEachThingOnce) {
  const std::string kkt = "residual 0.0074", reason = "KKT conditions: " + kkt;
  const Lines lines = printed([&] { print_result(summary_of(reason, kkt), "/nowhere", false); });
  ASSERT_EQ(lines.size(), 8u) << joined(lines);
  EXPECT_EQ(lines[0], "rod: optimal after 4 cycles (KKT conditions: " + kkt + ")");
  EXPECT_EQ(lines[1], "  mass 2 kg -> 2.52 kg (+26 %), worst limit -0.003 % +- 0.075 %, 0.567 s");
  EXPECT_EQ(lines[2], "  bending: 1 % more allowed saves 2.88 g");
  EXPECT_EQ(lines[5], "  note: the first note");
  for (const std::string& once : {kkt, std::string("the second note"), std::string("worst limit")})
    EXPECT_EQ(count(joined(lines), once), 1u) << joined(lines);
}

/// What the reason does not say of the conditions has a line of its own.
TEST(OptimizeTerminal, ConditionsThatAreNotTheReasonHaveALine) {
  const std::string kkt = "residual 0.3, rod_diameters[0] should grow";
  const std::string text = joined(printed(
      [&] { print_result(summary_of("cycle.max = 4 is used up", kkt), "/nowhere", false); }));
  EXPECT_EQ(count(text, "\n  KKT conditions: " + kkt + "\n"), 1u) << text;
  EXPECT_EQ(count(text, kkt), 1u) << text;
}

TEST(OptimizeTerminal, VariablesStandUnderEachOther) {
  const Lines lines = printed([] { print_result(summary_of("done", "done"), "/nowhere", false); });
  ASSERT_EQ(lines.size(), 8u) << joined(lines);
  EXPECT_EQ(lines[3], "  d                     0.01146 ->   0.00931886 m");
  EXPECT_EQ(lines[4], "  length_of_it[10]         12.5 ->       1234.5 m");
}

TEST(OptimizeTerminal, QuietPrintsNothing) {
  EXPECT_EQ(printed([] {
              print_cycle({}, SolidResponse::Mass, true);
              print_result(summary_of("done", "done"), "/nowhere", true);
            }),
            Lines());
}

class OptimizeTerminalOfAStudy : public Program {};

/// Of a study that ends otherwise than optimal: its summary and what was printed say the same,
/// once.
TEST_F(OptimizeTerminalOfAStudy, ReasonIsThatOfTheSummaryAndSaidOnce) {
  const Outcome o = run({"optimize", study("svanberg_cantilever"), "-o", results(), "--no-verify",
                         "--no-report", "--set", "cycle.max=1"});
  const Json s = summary();
  const std::string reason = s["reason"], status = s["status"];
  ASSERT_FALSE(reason.empty());
  EXPECT_EQ(count(reason, "worst limit"), 0u) << "it has its own key and line: " << reason;
  EXPECT_EQ(count(o.out, ": " + status + " after "), 1u) << o.out;
  EXPECT_EQ(count(o.out + o.err, reason), 1u) << o.out;
  EXPECT_EQ(count(o.out, "worst limit "), 2u) << "in the heading and at the end" << o.out;
  EXPECT_EQ(count(o.out, s["kkt"]), 1u) << o.out;
}

}  // namespace
}  // namespace liesl::test::optimize_terminal_test
