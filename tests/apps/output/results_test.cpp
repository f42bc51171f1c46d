/// What is written is read back with other means, number by number.

#include "apps/output/results.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <regex>
#include <sstream>

#include "apps/hdf5_set.hpp"
#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_writer.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/write_results.hpp"
#include "apps/output/xdmf_writer.hpp"
#include "tests/apps/output_sample.hpp"

namespace liesl::test::results_test {
namespace {

using namespace output;

using test::DataSet;
using test::read_set;

std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(read_file(path));
  for (std::string line; std::getline(text, line);) {
    std::vector<std::string> row(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) row.emplace_back();
      if (c != '"' && (c != ',' || quoted)) row.back() += c;
    }
    rows.push_back(row);
  }
  return rows;
}

using Shape = std::vector<hsize_t>;

TEST(Hdf5, EveryBlockComesBack) {
  const TemporaryFolder place;
  const Results r = sample_results();
  write_hdf5(place / "r.h5", r);
  const auto expect = [&](const std::string& name, const Shape& shape,
                          const std::vector<double>& values) {
    const DataSet set = read_set(place / "r.h5", name);
    EXPECT_EQ(set.shape, shape) << name;
    EXPECT_EQ(set.values, values) << name;
  };
  expect("/time", {5}, r.times);
  expect("/bodies/rod/position", {5, 3, 3}, r.bodies[0].positions);
  expect("/bodies/rod/rotation", {5, 3, 9}, r.bodies[0].rotations);
  expect("/bodies/rod/velocity", {5, 3, 6}, r.bodies[0].velocities);
  expect("/bodies/rod/strain", {5, 2, 6}, r.bodies[0].strains);
  expect("/bodies/rod/section_force", {5, 2, 12}, r.bodies[0].section_forces);
  const auto at = [&](std::size_t record, std::size_t element, std::size_t i) {
    return r.bodies[0].section_forces[(2 * record + element) * 12 + i];
  };
  std::vector<double> at_nodes;
  for (std::size_t n = 0; n < 5; ++n) {
    for (std::size_t i = 0; i < 6; ++i) at_nodes.push_back(at(n, 0, i));
    for (std::size_t i = 0; i < 6; ++i)
      at_nodes.push_back(0.5 * at(n, 0, 6 + i) + 0.5 * at(n, 1, i));
    for (std::size_t i = 0; i < 6; ++i) at_nodes.push_back(at(n, 1, 6 + i));
  }
  expect("/bodies/rod/node_force", {5, 3, 6}, at_nodes);
  expect("/bodies/rod/elements", {2, 2}, {0, 1, 1, 2});
  expect("/bodies/top_left/position", {5, 1, 3}, r.bodies[1].positions);
  expect("/meshes/plate/cells", {2, 4}, {0, 1, 4, 3, 1, 2, 5, 4});
  expect("/meshes/plate/fraction", {2}, r.meshes[0].fractions);
  expect("/meshes/plate/record", {3}, {0, 2, 4});
  expect("/meshes/plate/position", {3, 6, 3}, r.meshes[0].positions);
  expect("/meshes/plate/displacement", {3, 6, 3}, r.meshes[0].displacements);
  expect("/joints/pin/coordinate", {5, 2}, r.joints[0].coordinates);
  expect("/joints/pin/force", {5, 6}, r.joints[0].forces);
  expect("/energies/dissipated", {5}, r.energies.dissipated);
  expect("/constraint_residual", {5}, r.constraint_residual);
  expect("/responses/bend", {5, 1}, r.responses[0].values);
  expect("/responses/tip, far", {5, 3}, r.responses[1].values);
  expect("/bodies/top_left/strain", {}, {});
}

TEST(Hdf5, WrongShapesAreRefused) {
  const TemporaryFolder place;
  Results r = sample_results();
  r.bodies[0].strains.pop_back();
  try {
    write_hdf5(place / "r.h5", r);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "results: rod.strains has 59 numbers, expected 60");
  }
  r = sample_results();
  r.meshes[0].positions.pop_back();
  EXPECT_THROW(check_shapes(r), std::invalid_argument);
  r = sample_results();
  r.bodies[0].elements[1] = {1, 3};
  EXPECT_THROW(check_shapes(r), std::invalid_argument);
}

/// Blocks of series follow each other and are whole, and no record is left out.
TEST(Hdf5, RecordsThatAreMissingAreRefused) {
  const TemporaryFolder place;
  const BodyResult body = {"mass", "rigid", 1, {}, counting(3), counting(9), counting(6), {}, {}};
  Hdf5Writer file(place / "r.h5");
  EXPECT_THROW(file.put({body}, 1, 1, 3), std::invalid_argument) << "the second one";
  EXPECT_THROW(file.put({body}, 0, 2, 3), std::invalid_argument) << "numbers of one";
  file.put({body}, 0, 1, 3);
  file.put({body}, 1, 1, 3);
  Results results;
  results.times = counting(3);
  results.bodies = {body};
  results.kept = {0};
  EXPECT_NO_THROW(check_shapes(results));
  EXPECT_THROW(file.finish(results), std::invalid_argument) << "the third one";
  EXPECT_THROW(write_hdf5(place / "none.h5", results), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(place / "none.h5"));
  file.put({body}, 2, 1, 3);
  EXPECT_NO_THROW(file.finish(results));
}

TEST(Hdf5, ErrorsCarryPathAndReason) {
  const TemporaryFolder place;
  write_file(place / "file", "text");
  try {
    write_hdf5(place / "file/r.h5", sample_results());
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("file/r.h5"), std::string::npos) << error.what();
    EXPECT_NE(error.reason().find("Not a directory"), std::string::npos) << error.what();
  }
}

// A disk that fills up while the blocks are written, played by a limit on the size of files.
TEST(Hdf5, FullDiskThrows) {
  const TemporaryFolder place;
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{20000, 20000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Results r = sample_results();
    r.responses[0].values = counting(5);
    r.times = counting(100000);
    r.bodies.clear(), r.joints.clear(), r.responses.clear();
    r.energies = {};
    r.constraint_residual.clear();
    try {
      write_hdf5(place / "r.h5", r);
    } catch (const IoError&) {
      ::_exit(3);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
}

TEST(Xdmf, RefersToWhatIsThere) {
  const TemporaryFolder place;
  const Results r = sample_results();
  write_results(place.path(), r);
  const std::string text = read_file(place / "results.xdmf");
  EXPECT_NE(text.find("sample &amp; &lt;test&gt;"), std::string::npos);
  const std::regex item(
      R"re(Dimensions="([0-9 ]+)"[^>]* Format="HDF">results\.h5:([^<|]+)([^<]*)<)re");
  const std::regex slab(R"re(\|(\d+) 0 (\d):1 1 1:1 (\d+) (\d+):([0-9 ]+))re");
  int count = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), item), end; i != end; ++i, ++count) {
    const DataSet set = read_set(place / "results.h5", (*i)[2]);
    std::string shape;
    for (const hsize_t d : set.shape) shape += (shape.empty() ? "" : " ") + std::to_string(d);
    const std::string part = (*i)[3];
    std::smatch m;
    if (part.empty()) {
      EXPECT_EQ(shape, (*i)[1]) << (*i)[2];
      continue;
    }
    ASSERT_TRUE(std::regex_match(part, m, slab)) << part;
    EXPECT_EQ(shape, m[5]) << (*i)[2];
    EXPECT_EQ(m[3].str() + " " + m[4].str(), (*i)[1]) << (*i)[2];
    EXPECT_LT(std::stoul(m[1]), set.shape[0]);
    EXPECT_EQ(std::stoul(m[3]), set.shape[1]);
    EXPECT_LE(std::stoul(m[2]) + std::stoul(m[4]), set.shape[2]);
  }
  // 5 instants x (rod: topology, geometry, rotation, 2 x 3 halves; rigid: geometry, rotation, 2),
  // 3 of them with a mesh: topology, geometry, displacement, fraction.
  EXPECT_EQ(count, 5 * (9 + 4) + 3 * 4);
}

TEST(Xdmf, ListsSoManyInstantsAndNoMore) {
  const TemporaryFolder place;
  write_xdmf(place / "r.xdmf", "r.h5", sample_results(), 3);
  const std::string text = read_file(place / "r.xdmf");
  const std::regex time("<Time Value=\"([^\"]+)\"");
  std::vector<std::string> times;
  for (std::sregex_iterator i(text.begin(), text.end(), time), end; i != end; ++i) {
    times.push_back((*i)[1]);
  }
  EXPECT_EQ(times, (std::vector<std::string>{"0", "0.2", "0.4"}));
}

TEST(Csv, ResponsesWithUnitsAndAllDigits) {
  const TemporaryFolder place;
  const Results r = sample_results();
  write_responses_csv(place / "r.csv", r);
  const auto rows = read_csv(place / "r.csv");
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time [s]", "bend [m]", "tip, far.x [m]",
                                               "tip, far.y [m]", "tip, far.z [m]"}));
  EXPECT_EQ(std::stod(rows[5][1]), 1.0 / 3.0);
  EXPECT_EQ(std::stod(rows[2][4]), r.responses[1].values[5]);
}

TEST(Csv, JointsEnergiesAndFrames) {
  const TemporaryFolder place;
  write_results(place.path(), sample_results());
  const auto joints = read_csv(place / "joints.csv");
  EXPECT_EQ(joints[0][1], "pin.q0 [m]");
  EXPECT_EQ(joints[0][2], "pin.q1 [rad]");
  EXPECT_EQ(joints[0][8], "pin.Mz [N m]");
  EXPECT_EQ(std::stod(joints[1][8]), 1005.1);
  const auto energies = read_csv(place / "energies.csv");
  EXPECT_EQ(energies[0].back(), "constraint_residual [m or rad]");
  EXPECT_EQ(std::stod(energies[1][2]), 1.1);
  const auto frames = read_csv(place / "frames.csv");
  ASSERT_EQ(frames.size(), 1u + 5 * 4);
  EXPECT_EQ(frames[1], (std::vector<std::string>{"0", "rod", "beam", "0", "1000.1", "1001.1",
                                                 "1002.1", "0", "0", "0"}));
  EXPECT_EQ(frames[4][1], "top/left");
}

TEST(Csv, Design) {
  const TemporaryFolder place;
  write_design_csv(place / "d.csv",
                   {{"d[0]", "rod", 3, 0.1, 0.2, 0.01, 0.02, 0.004, 0.05, "m", "diameter"}});
  EXPECT_EQ(read_file(place / "d.csv"),
            "variable,body,element,s0 [m],s1 [m],initial,final,lower,upper,unit,dimension\n"
            "d[0],rod,3,0.1,0.2,0.01,0.02,0.004,0.05,m,diameter\n");
}

TEST(SpreadRecords, FirstAndLastAreAmongThem) {
  EXPECT_EQ(spread_records(0, 5), std::vector<int>{});
  EXPECT_EQ(spread_records(3, 5), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(spread_records(101, 5), (std::vector<int>{0, 25, 50, 75, 100}));
  EXPECT_EQ(spread_records(1000000, 2), (std::vector<int>{0, 999999}));
}

}  // namespace
}  // namespace liesl::test::results_test
