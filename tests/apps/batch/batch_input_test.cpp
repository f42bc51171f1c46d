/// @file
/// Batches as they are written: grids, tables, shards, and everything that is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "apps/batch/batch.hpp"
#include "apps/batch/case_table.hpp"
#include "apps/batch/grid.hpp"
#include "apps/good_scene.hpp"

namespace liesl::test::batch_input_test {
namespace {

namespace fs = std::filesystem;

std::vector<Axis> axes(const std::string& text) {
  return read_axes(*toml::parse(text, std::string("grid.toml"))["grid"].as_table());
}

/// Cases of a grid are all combinations, each once; by the digits of the case's number.
TEST(Grid, HoldsEveryCombinationOnce) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Axis> grid;
    std::size_t expected = 1;
    for (int a = 0; a < 1 + trial % 4; ++a) {
      Axis axis{{"a" + std::to_string(a), {"key" + std::to_string(a)}, {}}, {}};
      const int n = 1 + static_cast<int>(random() % 5);
      for (int v = 0; v < n; ++v) axis.values.push_back({std::to_string(v), {}});
      expected *= n;
      grid.push_back(axis);
    }
    const CaseList list = expand(grid);
    ASSERT_EQ(list.rows.size(), expected);
    std::set<std::vector<std::string>> seen;
    std::set<std::string> names;
    for (std::size_t k = 0; k < list.rows.size(); ++k) {
      EXPECT_TRUE(seen.insert(overrides(list, k)).second);
      EXPECT_TRUE(names.insert(list.rows[k].name).second);
      EXPECT_EQ(std::stoul(list.rows[k].name), k + 1);
    }
    EXPECT_EQ(std::is_sorted(seen.begin(), seen.end()), true);
  }
}

TEST(Grid, KeepsOrderKeysAndPlaces) {
  const auto grid = axes(
      "[grid]\n"
      "z = { key = [\"bodies.a.beam.elements\", \"bodies.b.beam.elements\"], values = [4, 8] }\n"
      "a = { key = \"name\", values = [\"x\", true, [1, 2.5]] }\n");
  ASSERT_EQ(grid.size(), 2u);
  EXPECT_EQ(grid[0].column.name, "z") << "as in the file, not by the alphabet";
  EXPECT_EQ(grid[0].values[1].place.line, 2);
  const CaseList list = expand(grid);
  ASSERT_EQ(list.rows.size(), 6u);
  EXPECT_EQ(overrides(list, 0), (std::vector<std::string>{"bodies.a.beam.elements=4",
                                                          "bodies.b.beam.elements=4", "name='x'"}));
  EXPECT_EQ(list.rows[1].values[1].text, "true");
  EXPECT_EQ(list.rows[5].values[1].text, "[1, 2.5]");
  EXPECT_EQ(list.rows[5].name, "6");
}

/// A number that keys of several units share has none of them.
TEST(Grid, UnitIsThatOfAllKeys) {
  Batch batch;
  const auto unit = [&batch](std::vector<std::string> keys) {
    return unit_of(batch, CaseColumn{"column", std::move(keys), {}});
  };
  EXPECT_EQ(unit({"simulation.step"}), "s");
  EXPECT_EQ(unit({"simulation.step", "simulation.duration"}), "s");
  EXPECT_EQ(unit({"simulation.step", "sections.rod.diameter"}), "");
  EXPECT_EQ(unit({"simulation.step", "bodies.rod.beam.elements"}), "");
  EXPECT_EQ(unit({"bodies.rod.beam.elements", "simulation.step"}), "");
  EXPECT_EQ(unit({"name"}), "");
  EXPECT_EQ(unit({}), "");
  batch.optimize = true;
  EXPECT_EQ(unit({"scene.simulation.step", "scene.simulation.duration"}), "s");
  EXPECT_EQ(unit({"scene.simulation.step", "scene.sections.rod.diameter"}), "");
  EXPECT_EQ(unit({"constraints.bending.limit"}), "") << "of the response: no unit";
}

/// Numbers reach the cases with every digit.
TEST(Grid, NumbersKeepTheirDigits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int k = 0; k < 1000; ++k) {
    const double x = std::pow(10, exponent(random));
    const auto grid = axes(fmt::format("[grid]\na = {{ key = \"k\", values = [{:.17e}] }}\n", x));
    EXPECT_EQ(*toml::parse("v = " + grid[0].values[0].text)["v"].value<double>(), x);
  }
}

TEST(Grid, CountsWithoutOverflow) {
  Axis axis;
  axis.values.resize(1000);
  EXPECT_EQ(combinations({axis}), 1000u);
  EXPECT_EQ(combinations(std::vector<Axis>(30, axis)), kMostCases + 1);
  EXPECT_EQ(combinations({}), 0u);
}

/// Any texts, quoted by the rules of RFC 4180, come back with the place of their first letter.
TEST(CsvTable, ReadsWhatIsQuoted) {
  const std::vector<std::vector<std::string>> rows = {
      {"a", "b,c", "d\"e"}, {"1\n2", "", "\"\""}, {"x\r\ny", "x y", ","}};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF";
    for (const auto& row : rows) {
      for (const std::string& cell : row) {
        text += "\"";
        for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
        text += &cell == &row.back() ? "\"" : "\",";
      }
      text += end;
    }
    Problems problems("t.csv");
    const auto read = read_csv(text, "t.csv", problems);
    ASSERT_EQ(problems.count(), 0);
    ASSERT_EQ(read.size(), 3u);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(read[r][c].text, rows[r][c]);
    EXPECT_EQ(read[0][1].place.column, 5);
  }
}

class BatchFiles : public testing::Test {
 protected:
  fs::path dir_ =
      fs::temp_directory_path() / ("liesl_batch_" + std::to_string(getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override {
    fs::create_directories(dir_);
    write("scene.toml", test::kGoodScene);
  }
  void TearDown() override { fs::remove_all(dir_); }
  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(dir_ / name) << text;
    return dir_ / name;
  }
  /// What is said of a batch, without the folder.
  std::string refusal(const std::string& text, const std::vector<std::string>& set = {}) const {
    try {
      load_batch(write("batch.toml", text), set);
    } catch (const InputError& error) {
      std::string what = error.what();
      for (auto at = what.find(dir_.string()); at != std::string::npos;
           at = what.find(dir_.string()))
        what.erase(at, dir_.string().size() + 1);
      return what;
    }
    return "";
  }
  std::string table(const std::string& text) const {
    write("cases.csv", text);
    return refusal("scene = \"scene.toml\"\ntable = \"cases.csv\"\n");
  }
};

TEST_F(BatchFiles, TableNamesItsCases) {
  write("cases.csv",
        "case,simulation.step, gravity.1\n"
        "slow,1e-3,-9.81\n"
        "\n"
        "fast,\"5e-4\",0\n");
  const Batch batch = load_batch(
      write("batch.toml", "scene = \"scene.toml\"\ntable = \"cases.csv\"\nlimits = { time = 5 }\n"),
      {"simulation.duration=0.1", "limits.memory=500"});
  EXPECT_FALSE(batch.optimize);
  ASSERT_EQ(batch.cases.rows.size(), 2u);
  EXPECT_EQ(batch.cases.rows[1].name, "fast");
  EXPECT_EQ(batch.changes(1), (std::vector<std::string>{"simulation.duration=0.1",
                                                        "simulation.step=5e-4", "gravity.1=0"}));
  EXPECT_EQ(batch.time, 5);
  EXPECT_EQ(batch.memory, 500);
  EXPECT_NE(batch.input.find("fast"), std::string::npos) << "the table is part of the hash";
  EXPECT_NE(batch.input.find("gravity = ["), std::string::npos) << "and the scene";
}

TEST_F(BatchFiles, ColumnsThatAreNoKeysAreRefusedAtTheirPlace) {
  EXPECT_EQ(table("case,simulation.stepp,bodies.rot.beam.elements\na,1,2\nb,2,3\n"),
            "cases.csv:1:6: unknown key 'simulation.stepp'; expected a key of the scene; "
            "hint: did you mean 'step'?\n"
            "cases.csv:1:23: there is no 'rot' in 'bodies'; expected a key of the scene; "
            "hint: did you mean 'rod'?");
  EXPECT_EQ(
      refusal(
          "scene = \"scene.toml\"\n[grid]\nh = { key = \"simulation.stepp\", values = [1, 2] }\n"),
      "batch.toml:3:13: unknown key 'simulation.stepp'; expected a key of the scene; "
      "hint: did you mean 'step'?");
}

TEST_F(BatchFiles, ValuesAreRefusedAtTheirPlaceAndOnce) {
  const std::string said = table("simulation.step,simulation.duration\n1e-3,1\n-1,1\n-1,soon\n");
  EXPECT_NE(said.find("cases.csv:3:1: 'simulation.step' is out of range: -1"), std::string::npos)
      << said;
  EXPECT_NE(said.find("cases.csv:4:4: 'simulation.duration' is a string"), std::string::npos)
      << said;
  const std::string grid = refusal(
      "scene = \"scene.toml\"\n[grid]\n"
      "h = { key = \"simulation.step\", values = [1e-3, 0] }\n"
      "g = { key = \"gravity.1\", values = [-1, -2, -3] }\n");
  EXPECT_EQ(grid.find("batch.toml:3:48: 'simulation.step' is out of range: 0"), 0u) << grid;
  EXPECT_EQ(std::count(grid.begin(), grid.end(), '\n'), 0) << grid;
}

TEST_F(BatchFiles, TablesThatAreNoneAreRefused) {
  const std::pair<std::string, const char*> wrong[] = {
      {"", "cases.csv: the table has 0 cases"},
      {"gravity.1\n", "cases.csv: the table has 0 cases"},
      {std::string("a\0b,c\n1,2\n", 8), "cases.csv: not a table: the file is binary"},
      {"a=b\n1\n", "cases.csv:1:1: 'a=b' is not a key"},
      {"case\na\n", "cases.csv:1:1: the table changes no key"},
      {"gravity.1,gravity.1\n1,2\n", "cases.csv:1:11: column 'gravity.1' is there twice"},
      {"gravity.1,\n1,2\n", "cases.csv:1:11: a column without a key"},
      {"gravity.1\n1,2\n", "cases.csv:2:1: a row of 2 fields; expected 1"},
      {"gravity.1,gravity.0\n1,\n", "cases.csv:2:3: an empty field"},
      {"case,gravity.1\na/b,1\n", "cases.csv:2:1: 'a/b' is no name of a case"},
      {"case,gravity.1\n..,1\n", "cases.csv:2:1: '..' is no name of a case"},
      {"case,gravity.1\na,1\na,2\n", "cases.csv:3:1: case 'a' is there twice"},
      {"gravity.1\n\"1\n", "cases.csv:2:1: a quote that is not closed"},
      {"status,gravity.1\n1,2\n", "cases.csv:1:1: 'status' is the name of a column"},
  };
  for (const auto& [text, message] : wrong)
    EXPECT_NE(table(text).find(message), std::string::npos) << text << "\n" << table(text);
}

TEST_F(BatchFiles, BatchesThatAreNoneAreRefused) {
  const std::string head = "scene = \"scene.toml\"\n";
  const std::pair<std::string, const char*> wrong[] = {
      {head + "[grid]\n", "batch.toml:2:1: the grid is empty; expected one axis or more"},
      {head + "[grid]\nh = { key = \"gravity.1\", values = [] }\n",
       "batch.toml:3:35: 'grid.h.values' is empty"},
      {head + "[grid]\nh = { key = \"gravity.1\", values = 3 }\n", "'grid.h.values' is an integer"},
      {head + "[grid]\nh = { values = [1] }\n", "missing key 'grid.h.key'"},
      {head + "[grid]\nh = { key = \"gravity.1\", values = [{}] }\n", "holds a table"},
      {head + "[limits]\n", "the batch has no cases"},
      {head + "table = \"absent.csv\"\n", "batch.toml:2:9: table absent.csv: No such file"},
      {head + "table = \"cases.csv\"\n[grid]\n", "both 'table' and 'grid'"},
      {"study = \"absent.toml\"\n[grid]\nh = { key = \"gravity.1\", values = [1] }\n",
       "batch.toml:1:9: there is no file absent.toml"},
      {"study = \"scene.toml\"\n[grid]\nh = { key = \"gravity.1\", values = [1] }\n",
       "this is a scene, not a study"},
      {"[grid]\nh = { key = \"gravity.1\", values = [1] }\n", "exactly one of study, scene"},
      {head + "[grid]\nstatus = { key = \"gravity.1\", values = [1] }\n",
       "'status' is the name of a column"},
      {head + "[grid]\na = { key = \"gravity.1\", values = [1] }\nb = { key = \"gravity.1\", "
              "values = [2] }\n",
       "batch.toml:4:13: key 'gravity.1' is there twice"},
      {test::kGoodScene, "this is a scene, not a batch"},
  };
  for (const auto& [text, message] : wrong)
    EXPECT_NE(refusal(text).find(message), std::string::npos) << text << "\n" << refusal(text);
}

TEST(Shard, IsInItsRange) {
  std::vector<int> times(100);
  for (int i = 1; i <= 7; ++i)
    for (std::size_t row = 0; row < times.size(); ++row)
      times[row] += read_shard(std::to_string(i) + "/7").has(row);
  EXPECT_EQ(times, std::vector<int>(100, 1));
  EXPECT_TRUE(read_shard("").has(12));
  for (const char* text : {"0/4", "5/4", "-1/4", "1/0", "4", "a/b", "1/4x", "/", "1/99999999999"})
    try {
      read_shard(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(std::string("--shard ") + text), 0u) << what;
      EXPECT_NE(what.find("1 <= i <= n"), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace liesl::test::batch_input_test
