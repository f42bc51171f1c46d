/// @file
/// `liesl map`: its values against those of an optimisation and closed forms, the local model
/// against the study it is the model of, and what it refuses.

#include <cmath>
#include <map>

#include "apps/batch/case_table.hpp"
#include "apps/program.hpp"

namespace liesl::test::map_test {
namespace {

using Columns = std::map<std::string, std::vector<double>>;

/// Numbers of map.csv by the names of its columns without units; NaN where a cell is empty.
Columns columns(const fs::path& path) {
  Problems problems("map.csv");
  const auto cells = read_csv(text_of(path), "", problems);
  Columns out;
  for (std::size_t r = 1; r < cells.size(); ++r)
    for (std::size_t c = 0; c < cells[0].size(); ++c) {
      const std::string& heading = cells[0][c].text;
      if (heading == "reason") continue;
      const std::string& cell = cells[r][c].text;
      out[heading.substr(0, heading.find(" ["))].push_back(cell.empty() ? NAN : std::stod(cell));
    }
  return out;
}

class Map : public Program {
 protected:
  static constexpr const char* kShort = "simulation.duration=0.02";
  Outcome map(const Words& more) const {
    Words words = {"map", "-q", "-f", "-o", results()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

/// Mass in closed form; limits as an optimisation finds them at its start.
TEST_F(Map, ValuesAreThoseOfTheStudy) {
  const fs::path to = dir_ / "optimum";
  ASSERT_LE(run({"optimize", study("slider_crank_rod"), "-q", "--no-report", "-o", to, "--set",
                 kShort, "--set", "cycle.max=2"})
                .code,
            1);
  const Json first = Json::parse(text_of(to / "summary.json"));
  const Outcome o =
      map({study("slider_crank_rod"), "--over", "rod_diameters[1]=0.01038:0.01238,rod_diameters[2]",
           "--points", "3,2", "--set", kShort, "--path", to, "--cycle", "1"});
  ASSERT_EQ(o.code, 0) << o.err;
  const Columns c = columns(results() / "map.csv");
  ASSERT_EQ(c.at("mass").size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = c.at("rod_diameters[1]")[k], b = c.at("rod_diameters[2]")[k], d = 0.01146;
    const double mass = 7850 * M_PI / 4 * 0.3 / 4 * (2 * d * d + a * a + b * b);
    EXPECT_NEAR(c.at("mass")[k], mass, 1e-12);
    EXPECT_NEAR(c.at("mass local")[k], mass, 1e-12);
    EXPECT_GT(c.at("bending")[k], 0);
  }
  for (const char* file : {"map.h5", "path.csv", "plots/map.png", "plots/map.svg"})
    EXPECT_TRUE(fs::exists(results() / file)) << file;
  EXPECT_EQ(summary()["command"], "map");
  EXPECT_EQ(summary()["designs"], 6);
  EXPECT_EQ(summary()["failed"], 0);
  EXPECT_EQ(keys(summary()), documented("### `map`").always);
  const Outcome at_start = map({study("slider_crank_rod"), "--over",
                                "rod_diameters[1]=0.01146:0.012,rod_diameters[2]=0.01146:0.012",
                                "--points", "2", "--of", "bending", "--set", kShort});
  ASSERT_EQ(at_start.code, 0) << at_start.err;
  EXPECT_NEAR(columns(results() / "map.csv").at("bending")[0],
              first["constraints"]["bending"]["max_abs_initial"].get<double>(), 1e-12);
}

/// The local model has value and gradient of the study: the gap falls with the square of the
/// distance.
TEST_F(Map, LocalModelIsOfFirstOrder) {
  const auto gap = [&](const std::string& method, double h) {
    const std::string range = "=" + std::to_string(0.01146 - h) + ":" + std::to_string(0.01146 + h);
    const Outcome o = map({study("slider_crank_rod"), "--over",
                           "rod_diameters[0]" + range + ",rod_diameters[1]" + range, "--points",
                           "3", "--set", kShort, "--set", "cycle.method=" + method});
    EXPECT_EQ(o.code, 0) << o.err;
    const Columns c = columns(results() / "map.csv");
    const auto &study = c.at("bending"), &local = c.at("bending local");
    EXPECT_NEAR(local[4], study[4], 1e-9 * study[4]) << "at the centre";
    double largest = 0;
    for (std::size_t k = 0; k < study.size(); ++k)
      largest = std::max(largest, std::abs(study[k] - local[k]));
    return largest;
  };
  for (const char* method : {"esl1", "full"}) {
    const double wide = gap(method, 4e-4), half = gap(method, 2e-4);
    EXPECT_NEAR(std::log2(wide / half), 2, 0.4) << method;
  }
  EXPECT_NEAR(std::log2(gap("esl", 4e-4) / gap("esl", 2e-4)), 1, 0.4)
      << "constant loads: value only";
}

/// Limits on a frequency and a mass: a hinged rod has f = pi/(2 L^2) sqrt(E/rho) d/4.
TEST_F(Map, HasLimitsOnFrequenciesAndMasses) {
  const double d = 0.01146;
  const Outcome o =
      map({study("slider_crank_rod"), "--over",
           "rod_diameters[0]=0.01146:0.012,rod_diameters[1]=0.01146:0.012", "--points", "2",
           "--set", kShort, "--set", "frequencies.tone={of=\"rod\",least=100}", "--set",
           "constraints.light={mass=\"rod\",limit=1}"});
  ASSERT_EQ(o.code, 0) << o.err;
  const Columns c = columns(results() / "map.csv");
  const double f = M_PI / (2 * 0.3 * 0.3) * std::sqrt(210e9 / 7850) * d / 4;
  EXPECT_NEAR(c.at("tone")[0] / f, 1, 0.01);
  EXPECT_GT(c.at("tone")[3], c.at("tone")[0]);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(c.at("light")[k], c.at("mass")[k], 1e-12);
  EXPECT_EQ(summary()["of"]["tone"]["limit"], 100);
  // They follow from the design alone: the local model has them as they are.
  for (const std::string name : {"tone", "light"})
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(c.at(name + " local")[k], c.at(name)[k], 1e-12 * c.at(name)[k]) << name << k;
}

/// Limits of a meshed part under its motion, as an optimisation finds them.
TEST_F(Map, HasLimitsOfAPartUnderItsMotion) {
  Words with = {"--set", "simulation.duration=0.002",
                "--set", "bodies.rod.solid.mesh.cells=[40,8]",
                "--set", "part_limits.tone={of=\"rod\",quantity=\"frequency\",limit=1000}",
                "--set", "part_limits.peak={of=\"rod\",quantity=\"stress\",limit=1e9}"};
  Words words = {study("connecting_rod"), "--over", "height=0.038:0.044,a1=0.004:0.006", "--points",
                 "2"};
  words.insert(words.end(), with.begin(), with.end());
  const Outcome o = map(words);
  ASSERT_EQ(o.code, 0) << o.err;
  const Columns c = columns(results() / "map.csv");
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_GT(c.at("tone")[k], 1000) << k;
    EXPECT_NEAR(c.at("tone local")[k], c.at("tone")[k], 1e-9 * c.at("tone")[k]) << k;
    EXPECT_GT(c.at("peak")[k], 0) << k;
  }
  EXPECT_NE(c.at("peak")[0], c.at("peak")[3]);
}

TEST_F(Map, FixedLoadsHaveNoLocalModel) {
  const Outcome o = map({study("plate_with_hole"), "--over", "a,b", "--points", "2"});
  ASSERT_EQ(o.code, 0) << o.err;
  const Columns c = columns(results() / "map.csv");
  EXPECT_EQ(c.size(), 2 + summary()["of"].size());
  EXPECT_NE(summary()["local"].get<std::string>().find("fixed loads"), std::string::npos);
  const auto of = summary()["of"];
  for (const auto& [name, entry] : of.items())
    for (const double value : c.at(name)) EXPECT_GT(value, 0) << name;
}

TEST_F(Map, RefusesWhatTheStudyHasNot) {
  const auto refused = [&](const Words& more, const char* why) {
    Words words = {study("slider_crank_rod")};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome o = map(words);
    EXPECT_EQ(o.code, 2) << why << o.out;
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(results()));
  };
  const std::string both = "rod_diameters[0],rod_diameters[1]";
  refused({"--over", "rod_diameters[0]"}, "1 variables");
  refused({"--over", "rod_diameter[0],rod_diameters[1]"}, "did you mean 'rod_diameters[0]'?");
  refused({"--over", "rod_diameters[1],rod_diameters[1]"}, "twice the same variable");
  refused({"--over", "rod_diameters[0]=0.001:0.01,rod_diameters[1]"}, "within the bounds");
  refused({"--over", "rod_diameters[0]=0.01:0.01,rod_diameters[1]"}, "FROM < TO");
  refused({"--over", "rod_diameters[0]=thin,rod_diameters[1]"}, "the range cannot be read");
  refused({"--over", both, "--of", "bendin"}, "did you mean 'bending'?");
  refused({"--over", both, "--points", "1"}, "1 points");
  refused({"--over", both, "--cycle", "2"}, "no path");
  refused({"--over", both, "--set",
           "objective={minimize=\"weighted\",of=\"rod\",weights={frequency=1}}"},
          "no objective that is a largest value or a lowest frequency");
  write("summary.json", R"({"command": "run"})");
  refused({"--over", both, "--path", dir_}, "holds no optimisation");
  write("summary.json", R"({"command": "optimize", "design": {"a": 1}, "history": []})");
  refused({"--over", both, "--path", dir_}, "not those of the study");
}

}  // namespace
}  // namespace liesl::test::map_test
