/// The keys of summary.json are an interface: they are listed here once more.

#include "apps/output/summary.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/progress.hpp"
#include "apps/output/summary_types.hpp"
#include "apps/output/versions.hpp"
#include "tests/apps/output_sample.hpp"

namespace liesl::test::summary_test {
namespace {

using namespace output;

RunSummary sample_run() {
  RunSummary s;
  s.name = "slider-crank";
  s.status = "done";
  s.factorizations = {{"crank", 1}, {"rod", 2}};
  const Results r = sample_results();
  for (const auto& response : r.responses)
    s.responses.push_back(response_figure(response, r.times));
  return s;
}

TEST(Summary, ResponseFigures) {
  const Results r = sample_results();
  const ResponseFigure bend = response_figure(r.responses[0], r.times);
  EXPECT_EQ(bend.max_abs, 0.4);
  EXPECT_EQ(bend.at_time, 0.1);
  EXPECT_EQ(bend.final, std::vector<double>{1.0 / 3.0});
  const ResponseFigure tip = response_figure(r.responses[1], r.times);
  EXPECT_DOUBLE_EQ(tip.max_abs, std::hypot(1012.1, 1013.1, 1014.1));
  EXPECT_EQ(tip.final.size(), 3u);
  EXPECT_TRUE(response_figure({"none", "m", 1, {}}, {}).final.empty());
}

TEST(Summary, RunHasItsKeys) {
  const auto json = to_json(sample_run());
  for (const char* key :
       {"status", "reason", "space", "steps", "newton_iterations", "factorizations", "stepping_s",
        "wall_s", "peak_memory_mb", "responses", "warnings", "versions", "input_sha256"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["factorizations"]["rod"], 2);
  EXPECT_EQ(json["responses"]["bend"]["max_abs"], 0.4);
  EXPECT_TRUE(json["responses"]["bend"]["final"].is_number());
  EXPECT_EQ(json["responses"]["tip, far"]["final"].size(), 3u);
  EXPECT_EQ(json["versions"]["liesl"], versions()[0].second);
  EXPECT_TRUE(json["versions"].contains("Eigen"));
  EXPECT_GT(json["peak_memory_mb"], 1.0);
}

TEST(Summary, FormerKeysAreKeptWithTheNewOnes) {
  RunSummary s = sample_run();
  EXPECT_FALSE(to_json(s).contains("goals"));
  s.more = {{"terms", {{"mass", {{"weight", 2.0}}}}},
            {"nucleation", {{"tried", {{{"feature", "hole1"}, {"cycles", 7}}}}}}};
  const auto json = to_json(s);
  EXPECT_EQ(json["goals"], json["terms"]);
  EXPECT_EQ(json["nucleation"]["tried"][0]["steps"], 7);
}

OptimizeSummary sample_optimisation() {
  OptimizeSummary s;
  static_cast<RunSummary&>(s) = sample_run();
  s.design = {{"d[0]", 0.01, 0.008, 0.004, 0.02}};
  s.constraints = {{"bending", "deflection", "m", 1e-3, 2e-3, 0.999e-3, 0.05, -1e-3}};
  s.history = {{1, 0.2, 1.0, std::nullopt, 20, 15, 0.5, 0.1}, {2, 0.1, 0.01, 0.3, 20, 9, 0.5, 0.1}};
  return s;
}

/// What pages, pictures and exports read is refused by its name if it is of another type.
TEST(Summary, KeysThatAreReadHaveTypes) {
  const auto json = to_json(sample_optimisation());
  EXPECT_EQ(wrong_type(json), "");
  const std::pair<const char*, const char*> keys[] = {
      {"/status", "status"},
      {"/warnings", "warnings"},
      {"/responses", "responses"},
      {"/responses/bend", "responses.bend"},
      {"/responses/bend/final", "responses.bend.final"},
      {"/responses/bend/unit", "responses.bend.unit"},
      {"/factorizations/rod", "factorizations.rod"},
      {"/design/d[0]", "design.d[0]"},
      {"/design_range/d[0]/lower", "design_range.d[0].lower"},
      {"/constraints/bending/violation", "constraints.bending.violation"},
      {"/history/1", "history[1]"},
      {"/history/1/mass", "history[1].mass"}};
  for (const auto& [pointer, name] : keys) {
    auto changed = json;
    changed[nlohmann::ordered_json::json_pointer(pointer)] = true;
    EXPECT_EQ(wrong_type(changed), fmt::format("'{}' is boolean", name));
  }
  auto mixed = json;
  mixed["responses"]["tip, far"]["final"][1] = "m";
  EXPECT_EQ(wrong_type(mixed), "'responses.tip, far.final' is array");
  auto holes = json;
  holes["nucleation"]["next"] = nullptr;
  EXPECT_EQ(wrong_type(holes), "");
  holes["nucleation"]["next"] = {{"place", {0.1, 0.2, 0}}, {"radius", 0.01}};
  EXPECT_EQ(wrong_type(holes), "");
  holes["nucleation"]["next"]["radius"] = "wide";
  EXPECT_EQ(wrong_type(holes), "'nucleation.next.radius' is string");
  nlohmann::ordered_json map;
  map["of"]["mass"]["range"] = {0.5, nullptr};
  EXPECT_EQ(wrong_type(map), "");
  map["of"]["mass"]["range"][1] = "wide";
  EXPECT_EQ(wrong_type(map), "'of.mass.range' is array");
}

TEST(Summary, OptimizeHasItsKeysBesides) {
  const auto json = to_json(sample_optimisation());
  for (const char* key : {"cycles", "mass_initial", "mass_final", "worst_constraint", "load_change",
                          "design", "history", "status", "responses", "versions"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["cycles"], 2);
  EXPECT_EQ(json["design"]["d[0]"], 0.008);
  EXPECT_EQ(json["constraints"]["bending"]["limit"], 1e-3);
  EXPECT_TRUE(json["history"][0]["load_change"].is_null());
  EXPECT_EQ(json["history"][1]["load_change"], 0.3);
}

TEST(Summary, IsAlwaysValidJson) {
  const TemporaryFolder place;
  RunSummary s = sample_run();
  s.wall_s = std::numeric_limits<double>::quiet_NaN();
  s.name = "\xff\xfe broken \"name\"";
  s.more = {{"modes", {1.0, 2.0}}};
  write_summary(place / "summary.json", to_json(s));
  const auto json = nlohmann::json::parse(read_file(place / "summary.json"));
  EXPECT_TRUE(json["wall_s"].is_null());
  EXPECT_EQ(json["modes"].size(), 2u);
}

TEST(Progress, SilentInPipes) {
  std::array<int, 2> ends;
  ASSERT_EQ(::pipe(ends.data()), 0);
  std::FILE* out = ::fdopen(ends[1], "w");
  {
    Progress progress("simulating", 10, "steps", out);
    progress.update(5);
    progress.say("kept");
  }
  std::fclose(out);
  std::array<char, 64> text{};
  EXPECT_EQ(::read(ends[0], text.data(), text.size() - 1), 5);
  EXPECT_STREQ(text.data(), "kept\n");
  ::close(ends[0]);
}

TEST(Progress, OneLineOnTerminals) {
  int master = -1, slave = -1;
  ASSERT_EQ(::openpty(&master, &slave, nullptr, nullptr, nullptr), 0);
  std::FILE* out = ::fdopen(slave, "w");
  {
    Progress progress("simulating", 1200, "steps", out);
    progress.update(600, "cycle 2");
  }
  std::fclose(out);
  std::string text;
  for (char c = 0; ::read(master, &c, 1) == 1;) text += c;
  EXPECT_EQ(text, "\rsimulating  50 %  600/1200 steps  cycle 2\033[K\r\033[K");
  ::close(master);
}

TEST(Progress, RateAndEstimate) {
  const Progress progress("simulating", 40000, "steps", nullptr);
  EXPECT_EQ(progress.line(10000, 25, ""), "simulating  25 %  10k/40k steps  400/s  1:15 left");
}

TEST(Interrupt, FirstSignalIsARequest) {
  catch_interrupts();
  EXPECT_EQ(interrupted(), 0);
  ::raise(SIGTERM);
  EXPECT_EQ(interrupted(), SIGTERM);
  EXPECT_THROW(check_interrupt(), Interrupted);
}

}  // namespace
}  // namespace liesl::test::summary_test
