/// Pages of results folders: what they hold, what they refuse.
#include "apps/report/report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "apps/output/cut_mesh.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/versions.hpp"
#include "apps/program.hpp"
#include "apps/report/blob.hpp"
#include "apps/report/loads.hpp"
#include "apps/report/motion.hpp"
#include "apps/report/page.hpp"
#include "apps/report/table.hpp"
#include "mbs/solids/meshes.hpp"

namespace liesl::test::report_test {
namespace {

using output::cut_mesh;
using output::CutMesh;
using report::Blob;

std::vector<unsigned char> bytes(const std::string& text) { return {text.begin(), text.end()}; }

TEST(ReportBlob, Base64OfTheStandard) {  // RFC 4648, section 10
  const std::vector<std::pair<std::string, std::string>> known = {{"", ""},
                                                                  {"f", "Zg=="},
                                                                  {"fo", "Zm8="},
                                                                  {"foo", "Zm9v"},
                                                                  {"foob", "Zm9vYg=="},
                                                                  {"fooba", "Zm9vYmE="},
                                                                  {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : known) {
    const auto data = bytes(plain);
    EXPECT_EQ(report::base64(data.data(), data.size()), coded);
  }
}

TEST(ReportBlob, ArraysAreDescribedAndAligned) {
  Blob blob;
  const auto a = blob.i16({1, -2, 0.5});
  const auto b = blob.f32({1, 2});
  EXPECT_EQ(a["n"], 3);
  EXPECT_NEAR(a["scale"].get<double>(), 2 / 32767.0, 1e-12);
  EXPECT_EQ(b["at"].get<std::size_t>() % 4, 0u);
  EXPECT_EQ(b["at"], 8);
  EXPECT_EQ(blob.bytes(), 16u);
}

TEST(ReportBlob, AComponentThatStaysIsOneNumber) {
  Blob blob;
  const auto c = blob.components({1, 7, 2, 7}, 2, Blob::Digits::Seven);
  EXPECT_TRUE(c[0].is_object());
  EXPECT_EQ(c[1], 7);
}

/// n x n squares of side 1/n, and the level of a function at their nodes.
struct Squares {
  std::vector<int> cells;
  std::vector<double> nodes, level;
  template <class Level>
  Squares(int n, const Level& phi) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double x = double(i) / n, y = double(j) / n;
        nodes.insert(nodes.end(), {x, y, 0});
        level.push_back(phi(x, y));
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i;
        cells.insert(cells.end(), {a, a + 1, a + n + 2, a + n + 1});
      }
  }
};

Eigen::Vector3d place(const CutMesh& mesh, const std::vector<double>& nodes, std::uint32_t v) {
  const auto& p = mesh.vertices[v];
  const auto at = [&](int i) { return Eigen::Vector3d::Map(&nodes[3 * std::size_t(i)]); };
  return (1 - p.t) * at(p.i) + p.t * at(p.j);
}

double area(const CutMesh& mesh, const std::vector<double>& nodes) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = place(mesh, nodes, t[0]);
    sum += 0.5 * (place(mesh, nodes, t[1]) - a).cross(place(mesh, nodes, t[2]) - a)[2];
  }
  return sum;
}

TEST(ReportCutMesh, ALineIsCutExactlyWhateverTheMesh) {
  for (const int n : {1, 2, 5, 8}) {
    const Squares s(n, [](double x, double y) { return 0.8 - x - 0.5 * y; });
    const CutMesh mesh = cut_mesh(cell_kind(2, 4), s.cells, s.nodes, s.level);
    EXPECT_NEAR(area(mesh, s.nodes), 0.55, 1e-12) << n;  // x < 0.8 - y/2 of the unit square
  }
}

TEST(ReportCutMesh, ADiscIsApproachedWithTheSquareOfTheCells) {
  const auto error = [](int n) {
    const Squares s(n, [](double x, double y) { return 0.3 - std::hypot(x - 0.5, y - 0.5); });
    return std::abs(area(cut_mesh(cell_kind(2, 4), s.cells, s.nodes, s.level), s.nodes) -
                    M_PI * 0.09);
  };
  EXPECT_NEAR(std::log2(error(20) / error(80)) / 2, 2, 0.3);
}

TEST(ReportCutMesh, SidesAreTheOutlineAndClosed) {
  const Squares s(8, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) - 0.3; });
  const CutMesh mesh = cut_mesh(cell_kind(2, 4), s.cells, s.nodes, s.level);
  std::vector<int> ends(mesh.vertices.size(), 0);
  double length = 0;
  for (const auto& [a, b] : mesh.sides) {
    ++ends[a];
    --ends[b];
    length += (place(mesh, s.nodes, b) - place(mesh, s.nodes, a)).norm();
  }
  EXPECT_EQ(ends, std::vector<int>(ends.size(), 0)) << "as many sides leave a point as reach it";
  EXPECT_NEAR(length, 4 + 2 * M_PI * 0.3, 0.03);
}

/// Volume by the divergence theorem: right only if the surface is closed and turned outward.
TEST(ReportCutMesh, TheSurfaceInSpaceIsClosedAndTurnedOutward) {
  std::vector<double> nodes, level;
  const int n = 6, m = n + 1;
  for (int k = 0; k < m; ++k)
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i) {
        nodes.insert(nodes.end(), {double(i) / n, double(j) / n, double(k) / n});
        level.push_back(0.9 - double(i) / n - 0.3 * double(j) / n - 0.2 * double(k) / n);
      }
  std::vector<int> cells;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = (k * m + j) * m + i, up = m * m;
        cells.insert(cells.end(),
                     {a, a + 1, a + m + 1, a + m, a + up, a + up + 1, a + up + m + 1, a + up + m});
      }
  const CutMesh mesh = cut_mesh(cell_kind(3, 8), cells, nodes, level);
  double volume = 0;
  for (const auto& t : mesh.triangles)
    volume +=
        place(mesh, nodes, t[0]).dot(place(mesh, nodes, t[1]).cross(place(mesh, nodes, t[2]))) / 6;
  EXPECT_NEAR(volume, 0.65, 1e-12);  // mean of 0.9 - 0.3 y - 0.2 z
}

/// Whole meshes of every kind of cell: area and closed outline, or volume of the closed surface.
TEST(ReportCutMesh, EveryKindOfCellIsDrawnClosedAndTurnedOutward) {
  for (const CellKind& kind : cell_kinds()) {
    if (kind.dim == 1) continue;
    const SolidMesh mesh = in_cells(
        kind.dim == 2 ? quad_grid({0, 0}, {2, 1}, 3, 2) : hex_grid({0, 0, 0}, {2, 1, 1}, 3, 2, 2),
        kind);
    const std::vector<double> nodes(mesh.nodes.data(), mesh.nodes.data() + mesh.nodes.size());
    const CutMesh cut =
        cut_mesh(kind, {mesh.cells.data(), mesh.cells.data() + mesh.cells.size()}, nodes, {});
    if (kind.dim == 2) {
      EXPECT_NEAR(area(cut, nodes), 2, 1e-12) << kind.name;
      std::vector<int> ends(cut.vertices.size(), 0);
      double twice_area = 0;
      for (const auto& [a, b] : cut.sides) {
        ++ends[a];
        --ends[b];
        twice_area += place(cut, nodes, a).cross(place(cut, nodes, b))[2];
      }
      EXPECT_EQ(ends, std::vector<int>(ends.size(), 0)) << kind.name;
      EXPECT_NEAR(twice_area, 4, 1e-12) << kind.name;  // material on the left
      continue;
    }
    double volume = 0, surface = 0;
    for (const auto& t : cut.triangles) {
      const Eigen::Vector3d a = place(cut, nodes, t[0]), b = place(cut, nodes, t[1]),
                            c = place(cut, nodes, t[2]);
      volume += a.dot(b.cross(c)) / 6;
      surface += (b - a).cross(c - a).norm() / 2;
    }
    EXPECT_NEAR(volume, 2, 1e-12) << kind.name;
    EXPECT_NEAR(surface, 10, 1e-12) << kind.name;
  }
}

TEST(ReportTable, ReadsQuotesAndUnits) {
  const fs::path file = fs::temp_directory_path() / ("liesl_table_" + std::to_string(getpid()));
  output::write_file(file, "time [s],\"a, \"\"b\"\"\",n\n0,x,\n1,\"y\nz\",2.5\n");
  const report::Table table = report::read_table(file);
  ASSERT_EQ(table.columns.size(), 3u);
  EXPECT_EQ(table.columns[0].unit, "s");
  EXPECT_EQ(table.columns[1].name, "a, \"b\"");
  EXPECT_EQ(table.columns[1].cells, (std::vector<std::string_view>{"x", "y\nz"}));
  EXPECT_THROW(table.numbers(table.columns[2]), output::IoError);  // an empty cell
  EXPECT_EQ(table.numbers(table.columns[0]), (std::vector<double>{0, 1}));
  output::write_file(file, "a,b\n1\n");
  EXPECT_THROW(report::read_table(file), output::IoError);
  fs::remove(file);
}

class ReportProgram : public Program {};

/// The JSON of a page.
Json data_of(const std::string& page) {
  const std::string open = "id=\"data\">";
  const std::size_t from = page.find(open) + open.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// The bytes of base64 text.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned kept = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) continue;  // =, line ends
    kept = kept << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(kept >> bits & 0xff);
  }
  return bytes;
}

/// An array of floats of a page.
std::vector<float> floats(const std::string& page, const Json& array) {
  const std::string open = "id=\"blob\">";
  const std::size_t from = page.find(open) + open.size();
  const std::string bytes = decoded(page.substr(from, page.find("</script>", from) - from));
  std::vector<float> values(array["n"].get<std::size_t>());
  std::memcpy(values.data(), bytes.data() + array["at"].get<std::size_t>(), 4 * values.size());
  return values;
}

TEST_F(ReportProgram, RunWritesAPageThatLoadsNothing) {
  const Outcome o = run({"run", (kData / "scenes/slider_crank.toml").string(), "-o",
                         results().string(), "--set", "simulation.duration=0.01"});
  EXPECT_EQ(o.code, 0) << o.err;
  const std::string page = text_of(results() / "report.html");
  EXPECT_LT(page.size(), 1'000'000u);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* address : {"src=\"http", "href=\"http", "url(http", "@import"})
    EXPECT_EQ(page.find(address), std::string::npos) << address;
  const Json data = data_of(page);
  EXPECT_EQ(data["motion"]["bodies"].size(), 3u);
  EXPECT_EQ(data["motion"]["joints"].size(), 4u);
  EXPECT_EQ(data["motion"]["bodies"][1]["shapes"][0], "circle");
  EXPECT_EQ(data["charts"].back()["title"], "energies");
  EXPECT_TRUE(output::foreign_files(results()).empty()) << "the page is liesl's own file";
}

/// Bands of page and pictures are as wide as the error in all.
TEST_F(ReportProgram, ErrorsOfAVerifiedRunAreDrawn) {
  ASSERT_EQ(run({"run", scene("slider_crank"), "-o", results(), "--verify", "--set",
                 "simulation.duration=0.01"})
                .code,
            0);
  const Json error = summary()["responses"]["bend"]["error"];
  ASSERT_TRUE(error.contains("total") && error.contains("end")) << error;
  const Json data = data_of(text_of(results() / "report.html"));
  int found = 0;
  for (const Json& chart : data["charts"]) {
    if (chart["title"] != "bend") continue;
    ++found;
    EXPECT_EQ(chart["error"], error["total"]);
  }
  EXPECT_EQ(found, 1);
  const Outcome drawn = run({"plot", results()});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
}

TEST_F(ReportProgram, InstantsOfALongRunAreThinnedAndSaid) {
  const Outcome o = run({"run", (kData / "scenes/slider_crank.toml").string(), "-o",
                         results().string(), "--set", "simulation.step=2e-5"});
  EXPECT_EQ(o.code, 0) << o.err;
  const std::string page = text_of(results() / "report.html");
  EXPECT_LT(page.size(), 1'000'000u);
  const Json motion = data_of(page)["motion"];
  EXPECT_EQ(motion["records"], 6001);
  EXPECT_LE(motion["t"]["n"].get<int>(), 600);
  const std::vector<float> t = floats(page, motion["t"]);
  EXPECT_TRUE(std::is_sorted(t.begin(), t.end()));
  EXPECT_TRUE(motion["opens"].is_null());  // at the largest deformation, which the page looks for
}

/// At the limit that is exceeded most, in the motion that is shown; without limits the page looks
/// for the largest deformation.
TEST(ReportOpening, IsThePeakOfTheLimitThatMattersMost) {
  report::Json summary = {{"responses", {{"tip", {{"at_time", 0.3}}}}}};
  EXPECT_FALSE(report::opening(summary));
  summary["constraints"]["bend (a)"] = {{"violation", -0.1}, {"at_time", 0.1}};
  summary["constraints"]["bend (b)"] = {{"violation", 0.2}, {"at_time", 0.2}};
  EXPECT_EQ(report::opening(summary), 0.2);
  summary["scenarios"] = {"a", "b"};
  EXPECT_EQ(report::opening(summary), 0.1);
  summary["constraints"]["bend (a)"]["at_time"] = nullptr;
  EXPECT_FALSE(report::opening(summary));
  EXPECT_FALSE(report::opening(report::Json::object()));
}

TEST_F(ReportProgram, CanBeLeftOutAndWrittenLater) {
  const Words words = {"run",        (kData / "scenes/pendulum.toml").string(),
                       "-o",         results(),
                       "--set",      "simulation.duration=0.01",
                       "--no-report"};
  EXPECT_EQ(run(words).code, 0);
  EXPECT_FALSE(fs::exists(results() / "report.html"));
  const Outcome o = run({"report", results().string()});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_TRUE(fs::exists(results() / "report.html"));
  EXPECT_EQ(run({"report", results().string()}).code, 0) << "its own page is replaced";
}

TEST_F(ReportProgram, WhatIsNoResultIsRefusedAndNothingWritten) {
  const auto refused = [&](const std::string& folder, const std::string& why) {
    const Outcome o = run({"report", folder});
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(fs::path(folder) / "report.html"));
  };
  refused((dir_ / "none").string(), "no such folder");
  fs::create_directories(dir_ / "empty");
  refused((dir_ / "empty").string(), "no summary.json");
  fs::create_directories(dir_ / "foreign");
  output::write_file(dir_ / "foreign/summary.json", "{\"a\": 1}");
  refused((dir_ / "foreign").string(), "not of liesl");
  ASSERT_EQ(run({"run", (kData / "scenes/pendulum.toml").string(), "-o", results().string(),
                 "--set", "simulation.duration=0.01", "--no-report"})
                .code,
            0);
  fs::copy(results(), dir_ / "other", fs::copy_options::recursive);
  std::string other = output::read_file(results() / "summary.json");
  other.replace(other.find("\"run\""), 5, "\"sum\"");
  output::write_file(dir_ / "other/summary.json", other);
  refused((dir_ / "other").string(), "its command is 'sum', none that leaves results");
  fs::copy(results(), dir_ / "nan", fs::copy_options::recursive);
  std::string table = output::read_file(results() / "responses.csv");
  table.replace(table.rfind(','), table.npos, ",nan\n");
  output::write_file(dir_ / "nan/responses.csv", table);
  refused((dir_ / "nan").string(), "'nan' of column 'bend' in line 12 is no finite number");
  for (const char* name : {"responses.csv", "energies.csv", "joints.csv"}) {  // cut between lines
    const fs::path cut = dir_ / (std::string("cut_") + name);
    fs::copy(results(), cut, fs::copy_options::recursive);
    const std::string whole = output::read_file(cut / name);
    output::write_file(cut / name, whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
    refused(cut.string(),
            std::string(name) + "': it has 10 rows, and the records of results.h5 are 11");
    EXPECT_EQ(run({"plot", cut.string()}).code, 3);
    EXPECT_FALSE(fs::exists(cut / "plots"));
  }
  fs::resize_file(results() / "results.h5", 3000);
  refused(results().string(), "results.h5");
  fs::copy(results(), dir_ / "half", fs::copy_options::recursive);
  output::write_file(dir_ / "half/summary.json", "{\"versions\": {\"liesl\"");
  refused((dir_ / "half").string(), "not whole");
  output::write_file(dir_ / "half/summary.json", "{\"versions\": {\"liesl\": \"0.0.9\"}}");
  refused((dir_ / "half").string(), "it is of liesl \"0.0.9\"");
  for (const char* name : {"results.h5", "responses.csv", ".liesl"}) {
    const fs::path part = dir_ / (std::string("without_") + name);
    fs::copy(results(), part, fs::copy_options::recursive);
    fs::remove(part / name);
    refused(part.string(), std::string("its ") + name + " is not there");
  }
  fs::create_directories(dir_ / "summary");
  fs::copy(results() / "summary.json", dir_ / "summary");
  refused((dir_ / "summary").string(), "its .liesl is not there");
}

/// Comparisons and batches name files before they are there.
TEST_F(ReportProgram, WhatIsInterruptedHasAPage) {
  fs::create_directories(dir_ / "rows");
  output::write_file(dir_ / "rows/summary.json",
                     "{\"command\": \"compare\", \"name\": \"c\", \"status\": \"interrupted\", "
                     "\"done\": 2, \"versions\": {\"liesl\": " +
                         nlohmann::json(output::versions().front().second).dump() + "}}");
  output::write_file(dir_ / "rows/rows.csv", "run,status\n1,done\n2,done\n");
  output::mark_files(dir_ / "rows", {"rows.csv", "reference_1.csv", "summary.json"});
  EXPECT_EQ(run({"report", (dir_ / "rows").string()}).code, 0);
  const auto refused = [&](const char* rows, const char* why) {
    output::write_file(dir_ / "rows/rows.csv", rows);
    const Outcome o = run({"report", (dir_ / "rows").string()});
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
  };
  refused("run,model,status,error [m],reason\n1,abc,done,,\n2,x,done,abc,y\n",
          "rows.csv': 'abc' of column 'error' in line 3 is no number");
  output::write_file(dir_ / "rows/rows.csv", "run,status\n1,done\n");
  const Outcome half = run({"report", (dir_ / "rows").string()});
  EXPECT_EQ(half.code, 3);
  EXPECT_NE(half.err.find("it has 1 rows, and summary.json tells of 2"), std::string::npos);
  fs::remove(dir_ / "rows/rows.csv");
  const Outcome o = run({"report", (dir_ / "rows").string()});
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("its rows.csv is not there"), std::string::npos) << o.err;
}

/// Pages stay small whatever the number of cycles: evenly spread ones, and the last one.
TEST_F(ReportProgram, LoadsOfManyCyclesAreThinned) {
  std::string table =
      "cycle,scenario,body,time [s],node,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m],"
      "x [m],y [m],z [m]\n";
  constexpr int kCycles = 26, kInstants = 3, kNodes = 65;
  for (int cycle = 1; cycle <= kCycles; ++cycle)
    for (int i = 0; i < kInstants; ++i)
      for (int node = 0; node < kNodes; ++node)
        table += fmt::format("{},,rod,{},{},{},1,0,0,0,0.5,,,\n", cycle, 0.1 * i, node, cycle);
  output::write_file(dir_ / "cycle_loads.csv", table);
  report::Blob blob;
  const report::Json loads = report::cycle_loads(dir_, blob);
  EXPECT_TRUE(loads["thinned"].get<bool>());
  std::set<int> kept;
  for (const auto& load : loads["cases"]) kept.insert(load["cycle"].get<int>());
  EXPECT_EQ(kept, (std::set<int>{2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26}));
  EXPECT_EQ(loads["cases"].size(), kInstants * kept.size());
  EXPECT_EQ(loads["load"][0]["n"], kNodes * kInstants * kept.size());
  EXPECT_EQ(loads["load"][1], 1.0) << "a component that never changes is one number";
  EXPECT_EQ(loads["load"][2], 0.0);
}

/// Loads have no gaps; where they act there are some.
TEST_F(ReportProgram, LoadsThatAreNoNumbersAreRefused) {
  const std::string head =
      "cycle,scenario,body,time [s],node,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m],"
      "x [m],y [m],z [m]\n";
  report::Blob blob;
  output::write_file(dir_ / "cycle_loads.csv", head + "1,,rod,0.1,0,1,0,0,0,0,0,,,\n");
  EXPECT_EQ(report::cycle_loads(dir_, blob)["cases"].size(), 1u);
  for (const char* cell : {"abc", "nan", ""}) {
    output::write_file(dir_ / "cycle_loads.csv", head + "1,,rod,0.1,0," + cell + ",0,0,0,0,0,,,\n");
    try {
      report::cycle_loads(dir_, blob);
      ADD_FAILURE() << cell;
    } catch (const output::IoError& error) {
      EXPECT_EQ(error.reason(), std::string("'") + cell +
                                    "' of column 'Fx' in line 2 is no finite number: run it again");
    }
  }
}

TEST_F(ReportProgram, APageOfTheUserStays) {
  ASSERT_EQ(run({"run", (kData / "scenes/pendulum.toml").string(), "-o", results().string(),
                 "--set", "simulation.duration=0.01", "--no-report"})
                .code,
            0);
  output::write_file(results() / "report.html", "mine");
  const Outcome o = run({"report", results().string()});
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("liesl did not write it"), std::string::npos) << o.err;
  EXPECT_EQ(text_of(results() / "report.html"), "mine");
}

TEST(ReportPage, HashesAreOfItsTexts) {
  EXPECT_EQ(report::kScriptHash, output::sha256(report::kScript));
  EXPECT_EQ(report::kStyleHash, output::sha256(report::kStyle));
}

TEST(ReportPage, TextsCannotEndTheScript) {
  const nlohmann::ordered_json data = {{"name", "</script><script>alert(1)</script><!--"}};
  const std::string page = report::page(data, "");
  EXPECT_EQ(page.find("</script><script>alert"), std::string::npos);
  EXPECT_EQ(data_of(page)["name"].get<std::string>(), data["name"].get<std::string>());
}

}  // namespace
}  // namespace liesl::test::report_test
