/// @file
/// Comparisons: grids, refusals, orders of convergence, resumption, pictures.
#include <algorithm>
#include <cmath>
#include <map>

#include "apps/batch/case_table.hpp"
#include "apps/compare/comparison.hpp"
#include "apps/compare/conserved.hpp"
#include "apps/input/document.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "mbs/system/energy.hpp"

namespace liesl::test::compare_test {
namespace {

using Row = std::map<std::string, std::string>;

/// Rows of rows.csv by the names of their columns, without units.
std::vector<Row> read_rows(const fs::path& path) {
  Problems problems("rows.csv");
  const auto cells = read_csv(text_of(path), "", problems);
  std::vector<Row> rows;
  for (std::size_t r = 1; r < cells.size(); ++r) {
    Row& row = rows.emplace_back();
    for (std::size_t c = 0; c < cells[0].size(); ++c) {
      const std::string& heading = cells[0][c].text;
      row[heading.substr(0, heading.find(" ["))] = cells[r][c].text;
    }
  }
  return rows;
}

double number(const Row& row, const char* column) { return std::stod(row.at(column)); }

/// Fitted slope of log error over log x.
double slope(const std::vector<Row>& rows, const char* axis) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Row& row : rows) {
    const double a = std::log(number(row, axis)), b = std::log(number(row, "error"));
    x += a, y += b, xx += a * a, xy += a * b;
  }
  const auto n = static_cast<double>(rows.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

class Compare : public Program {
 protected:
  std::string head(const char* scene_name, const char* response,
                   const std::string& norm = "final") const {
    return "scene = \"" + scene(scene_name) + "\"\nrepeats = 1\n[quantity]\nresponse = \"" +
           response + "\"\nnorm = \"" + norm + "\"\n";
  }
  Outcome compare(const std::string& text, const Words& more = {}) const {
    Words words = {"compare", write("study.toml", text), "-o", results()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// What is said of a comparison, without the folder.
  std::string refusal(const std::string& text) const {
    const Outcome o = run({"check", write("study.toml", text)});
    EXPECT_EQ(o.code, 2) << text;
    std::string said = o.err;
    for (auto at = said.find(dir_.string()); at != std::string::npos; at = said.find(dir_.string()))
      said.erase(at, dir_.string().size() + 1);
    return said;
  }
  std::vector<Row> rows() const { return read_rows(results() / "rows.csv"); }
};

const std::string kTopGrid =
    "[grid]\nformalism = [\"se3\", \"r3so3\"]\nstep = [1e-3, 5e-4, 2.5e-4]\n";
const std::string kTopReference =
    "[reference]\nformalisms = [\"r3so3\", \"se3\"]\nstep = 5e-5\nextrapolate = \"step\"\n"
    "[set]\n\"simulation.duration\" = 0.1\n";

/// Formalisms are compared with elements of one order unless the comparison says otherwise.
TEST_F(Compare, BeamsAreOfOrderTwoUnlessAskedFor) {
  const auto orders = [this](const std::string& text, const std::vector<std::string>& set = {}) {
    const Comparison comparison =
        load_comparison(write("study.toml", head("slider_crank", "bend") + text), set);
    std::vector<int> found;
    const auto add = [&](const std::vector<std::string>& changes) {
      const Mechanism m = load_scene(comparison.rows.of, changes).mechanism;
      for (const BodySpec& body : m.bodies)
        if (const auto* beam = std::get_if<BeamSpec>(&body.kind)) found.push_back(beam->order);
    };
    for (std::size_t row = 0; row < comparison.rows.cases.rows.size(); ++row)
      add(comparison.rows.changes(row));
    if (comparison.reference)
      for (const ReferenceRun& run : comparison.reference_runs(0, 1)) add(run.changes);
    return found;
  };
  const std::string grid = "[grid]\nformalism = [\"se3\", \"r3so3\"]\n";
  const std::string reference = "[reference]\nformalisms = [\"r3so3\", \"se3\"]\nstep = 1e-4\n";
  EXPECT_EQ(orders(grid), (std::vector<int>{2, 2, 2, 2}));
  EXPECT_EQ(orders(grid + reference), (std::vector<int>{2, 2, 2, 2, 2, 2}));
  const std::string one = "[grid]\nformalism = [\"se3\"]\n";
  EXPECT_EQ(orders(one + "[set]\n\"bodies.rod.beam.order\" = 4\n"), (std::vector<int>{2, 4}));
  EXPECT_EQ(orders(one, {"bodies.crank.beam.order=4"}), (std::vector<int>{4, 2}));
  EXPECT_EQ(orders(one + "[vary]\norder = { key = \"bodies.rod.beam.order\", values = [2, 4] }\n"),
            (std::vector<int>{2, 2, 2, 4}));
}

TEST_F(Compare, RowsAreEveryCombination) {
  const fs::path file = write("study.toml", head("slider_crank", "bend") +
                                                "[grid]\nelements = [2, 4]\nstep = [1e-3, 5e-4]\n"
                                                "formalism = [\"rigid\", \"se3\", \"classical\"]\n"
                                                "[vary]\nrate = { key = \"joints.motor.drive.rate\""
                                                ", values = [50, 100] }\n");
  const Comparison c = load_comparison(file, {"simulation.duration=0.01", "repeats=7"});
  ASSERT_EQ(c.rows.cases.rows.size(), 24u);
  EXPECT_EQ(c.repeats, 7);
  EXPECT_EQ(c.smallest_step, 5e-4);
  EXPECT_EQ(
      c.rows.changes(0),
      (Words{"bodies.crank.beam.order=2", "bodies.rod.beam.order=2", "simulation.duration=0.01",
             "bodies.crank.beam.elements=2", "bodies.rod.beam.elements=2", "simulation.step=0.001",
             "simulation.formalism='rigid'", "joints.motor.drive.rate=50"}));
  EXPECT_EQ(c.physics(23), Words{"joints.motor.drive.rate=100"})
      << "what is numerical does not ask for another reference";
}

/// Shares of the extrapolated runs add up to one, and cancel errors h^2, l^2 and h^2 l^2.
TEST_F(Compare, ExtrapolationCancelsSecondOrders) {
  const fs::path file =
      write("study.toml", head("pendulum", "tip") +
                              "[reference]\nformalisms = [\"se3\", \"rigid\"]\nelements = 8\n"
                              "step = 1e-3\nextrapolate = \"both\"\n[grid]\nstep = [4e-3]\n");
  const auto runs = load_comparison(file).reference_runs(0, 1);
  ASSERT_EQ(runs.size(), 4u);
  double one = 0, h2 = 0, l2 = 0, both = 0;
  for (const ReferenceRun& r : runs) {
    const Scene read = load_scene(scene("pendulum"), r.changes);
    EXPECT_EQ(read.mechanism.formalism, Formalism::Rigid);
    const auto& beam = std::get<BeamSpec>(read.mechanism.bodies[0].kind);
    const double h = std::pow(read.simulation.step, 2);
    const double l = std::pow(1.0 / static_cast<double>(beam.nodes.size() - 1), 2);
    one += r.weight, h2 += r.weight * h, l2 += r.weight * l, both += r.weight * h * l;
    EXPECT_NEAR(read.simulation.step * read.simulation.output_every, 4e-3, 1e-15);
  }
  EXPECT_NEAR(one, 1, 1e-15);
  EXPECT_NEAR(h2, 0, 1e-20);
  EXPECT_NEAR(l2, 0, 1e-16);
  EXPECT_NEAR(both, 0, 1e-20);
}

/// A mesh in the place of a beam is a row by the name of its model, with the reference of the
/// grid: the same bending, nearer to it with more cells.
TEST_F(Compare, ModelsAreRows) {
  const std::string model =
      "[models.mesh]\nelements = { key = \"bodies.rod.solid.mesh.cells.0\", values = [4, 32] }\n"
      "[models.mesh.set.\"bodies.rod\".solid]\nas = \"continuum\"\nmaterial = \"steel\"\n"
      "at = [0.15, 0, 0]\nthickness = 9.0689968e-3\n"
      "mesh = { from = [0, -4.330127e-3], to = [0.3, 4.330127e-3], cells = [8, 2] }\n"
      "[models.mesh.set.\"bodies.rod\".solid.interfaces]\nstart = { set = \"x_min\" }\n"
      "mid = { box = { from = [0.149, -1], to = [0.151, 1] } }\nend = { set = \"x_max\" }\n";
  const std::string text =
      head("slider_crank", "bend") +
      "[reference]\nformalisms = [\"r3so3\", \"se3\"]\nelements = 16\nstep = 1e-4\n"
      "extrapolate = \"mesh\"\n[grid]\nformalism = [\"se3\", \"rigid\"]\nelements = [4]\n"
      "step = [1e-4]\n[set]\n\"simulation.duration\" = 0.02\n";
  const std::string penalty = "[models.soft]\nset = { \"simulation.constraints\" = \"penalty\" }\n";
  const Outcome o = compare(text + model + penalty);
  ASSERT_EQ(o.code, 0) << o.err;
  const auto all = rows();
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[2].at("formalism"), "mesh");
  EXPECT_EQ(all[2].at("elements"), "4");
  EXPECT_EQ(all[4].at("formalism"), "soft");
  EXPECT_EQ(summary()["references"].size(), 1u);
  const double size = number(all[1], "error");  // a rigid rod does not bend at all
  EXPECT_LT(number(all[3], "error"), 0.02 * size);
  EXPECT_LT(number(all[3], "error"), 0.2 * number(all[2], "error"));
  EXPECT_NEAR(number(all[4], "error"), number(all[0], "error"), 1e-3 * size);
  EXPECT_NE(all[4].at("error"), all[0].at("error"));
  EXPECT_EQ(summary()["ratios"].size(), 2u) << "meshes of its own have no pairs, not even 4 cells";

  const std::pair<std::string, const char*> wrong[] = {
      {text + "[models.se3]\nset = {}\n", "'se3' is the name of a formalism"},
      {text + "[models.soft]\n", "missing key 'models.soft.set'"},
      {text + "[models.soft]\nset = { \"simulation.constraint\" = 1 }\n",
       "did you mean 'constraints'?"},
      {head("pendulum", "tip") + "[grid]\nstep = [1e-3]\n" + penalty,
       "study.toml:8:1: the grid has no formalism, in whose place the model stands"},
      {head("slider_crank", "bend") + "[grid]\nformalism = [\"se3\"]\n" + model,
       "study.toml:9:12: the grid has no elements, in whose place these stand"},
      {text + std::string(model).replace(model.find("mid ="), 3, "middle"),
       "part 'rod' has no interface 'mid' between its first and its last one; expected one of "
       "middle, or max"},
  };
  for (const auto& [bad, message] : wrong) {
    const std::string said = refusal(bad);
    EXPECT_NE(said.find(message), std::string::npos) << bad << "\n" << said;
  }
}

TEST(SeriesOfComparisons, CubicsAreExactBetweenInstants) {
  const auto f = [](double t) { return 1 - t + 2 * t * t - 3 * t * t * t; };
  using output::Norm;
  const auto sampled = [&](int n) {
    output::Series s;
    s.values.resize(1, n + 1);
    for (int k = 0; k <= n; ++k) {
      s.t.push_back(static_cast<double>(k) / n);
      s.values(0, k) = f(s.t.back());
    }
    return s;
  };
  output::Series fine = sampled(10);
  const output::Series coarse = sampled(7);
  for (const Norm norm : {Norm::Final, Norm::Max, Norm::Rms})
    EXPECT_LT(distance(coarse, fine, norm), 1e-14) << name_of(norm);
  fine.values.array() += 2;
  for (const Norm norm : {Norm::Final, Norm::Max, Norm::Rms})
    EXPECT_NEAR(distance(coarse, fine, norm), 2, 1e-14) << name_of(norm);
}

/// Momentum of a body in space is that of its mass and its inertia.
TEST(MomentumOfModels, IsThatOfTheRigidBody) {
  const Scene top = load_scene(scene("heavy_top"));
  const Model<SE3> model = Model<SE3>::build(top.mechanism, {});
  const SE3::Tangent p = momentum(model, model.initial_state());
  const Vec3 v(4.61538, 0, 0), w(0, 150, -4.61538), x(0, 1, 0);
  const Vec3 L = Vec3(0.234375, 0.46875, 0.234375).cwiseProduct(w) + 15 * x.cross(v);
  EXPECT_LT((p.head<3>() - 15 * v).norm(), 1e-9);
  EXPECT_LT((p.tail<3>() - L).norm(), 1e-9);
}

/// What a comparison calls the drift of the energy has the springs in it.
TEST(DriftOfModels, IsNothingForAMassOnASpring) {
  Mechanism m;
  RigidSpec mass;
  mass.mass = 2;
  mass.inertia.setIdentity();
  m.bodies = {{"mass", mass}};
  m.joints = {{"slide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
  ForceSpec spring;
  spring.joint = 0;
  spring.stiffness = 50;
  spring.rest = -0.1;
  m.forces = {spring};
  Model<SE3> model = Model<SE3>::build(m, {});
  SimulationOptions options;
  options.duration = 2;
  options.step = 1e-3;
  options.rho_inf = 1;
  options.tolerance = 1e-10;
  const auto result = simulate(model, options);
  ASSERT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  const Drift found = drift(m, model, result.trajectory);
  ASSERT_TRUE(found.energy);
  EXPECT_LT(*found.energy, 1e-9 * 0.25) << "of 0.25 J";
}

TEST_F(Compare, OrdersAreTwo) {
  const Outcome o = compare(head("heavy_top", "centre", "rms") + kTopReference + kTopGrid);
  ASSERT_EQ(o.code, 0) << o.err;
  const auto all = rows();
  ASSERT_EQ(all.size(), 6u);
  for (const char* formalism : {"se3", "r3so3"}) {
    std::vector<Row> of;
    for (const Row& row : all)
      if (row.at("formalism") == formalism) of.push_back(row);
    EXPECT_NEAR(slope(of, "step"), 2, 0.1) << formalism;
    for (const Row& row : of) {
      EXPECT_EQ(row.at("status"), "converged");
      EXPECT_EQ(number(row, "steps"), std::round(0.1 / number(row, "step")));
      EXPECT_GT(number(row, "error"), 3 * number(row, "floor"));
      EXPECT_GT(number(row, "energy_drift"), 0);
      EXPECT_EQ(row.at("momentum_drift"), "") << "the top is tied to the ground";
    }
  }
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_EQ(summary()["references"].size(), 1u);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < 3; ++i)
    ratios.push_back(number(all[3 + i], "error") / number(all[i], "error"));
  std::sort(ratios.begin(), ratios.end());
  const auto ratio = summary()["ratios"][0];
  EXPECT_EQ(summary()["ratios"].size(), 1u);
  EXPECT_EQ(ratio["formalism"], "r3so3");
  EXPECT_EQ(ratio["to"], "se3");
  EXPECT_EQ(ratio["pairs"], 3);
  EXPECT_DOUBLE_EQ(ratio["error"], ratios[1]);
  EXPECT_GT(ratio["time"], 0);
  EXPECT_NE(o.out.find("r3so3 against se3, medians of 3 pairs of rows: error"), std::string::npos);
  EXPECT_EQ(keys(summary()), documented("### `compare`\n").always);
}

/// On SE(3) the momentum drifts by an error of the mesh and one of second order in the step; where
/// positions are inertial it stays.
TEST_F(Compare, MomentumOfFreeFlightIsWatched) {
  const Outcome o = compare(head("flying_beam", "A") +
                            "[grid]\nformalism = [\"se3\", \"r3so3\"]\nelements = [4]\n"
                            "step = [0.04, 0.02, 0.01]\n[set]\n\"simulation.duration\" = 7\n");
  ASSERT_EQ(o.code, 0) << o.err;
  const auto all = rows();
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].at("error"), "") << "there is no reference";
  double lie[3], decoupled[3];
  for (std::size_t k = 0; k < 3; ++k) {
    lie[k] = number(all[k], "momentum_drift");
    decoupled[k] = number(all[k + 3], "momentum_drift");
    EXPECT_LT(decoupled[k], 1e-3 * lie[k]);
    EXPECT_GT(number(all[k], "energy_drift"), 0);
  }
  EXPECT_NEAR((lie[0] - lie[1]) / (lie[1] - lie[2]), 4, 0.4);
}

/// A second command runs what is missing, and nothing else: rows that are there keep every letter.
TEST_F(Compare, GoesOnWhereItStopped) {
  const std::string text = head("heavy_top", "centre") + kTopReference + kTopGrid;
  ASSERT_EQ(compare(text).code, 0);
  const std::string whole = text_of(results() / "rows.csv");
  std::string cut = whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1);
  const std::string marker = "12345.5";
  const auto lines = read_rows(results() / "rows.csv");
  const std::string cpu = lines[0].at("cpu_s");
  cut.replace(cut.find("," + cpu + ",") + 1, cpu.size(), marker);
  std::ofstream(results() / "rows.csv") << cut << "6,r3so3,0.00";  // and half a row
  ASSERT_EQ(compare(text).code, 0);
  const auto again = rows();
  ASSERT_EQ(again.size(), 6u);
  EXPECT_EQ(again[0].at("cpu_s"), marker) << "run again";
  EXPECT_EQ(again[5].at("error"), lines[5].at("error"));
  EXPECT_EQ(compare(text + "elements_of = 1\n").code, 2);
  const Outcome other = compare(text, {"--set", "simulation.duration=0.05"});
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("belongs to another"), std::string::npos) << other.err;
  EXPECT_EQ(compare(text, {"--force"}).code, 0);
  EXPECT_NE(rows()[0].at("cpu_s"), marker);
}

TEST_F(Compare, FoldersOfOthersAreRefusedByName) {
  fs::create_directory(results());
  for (const char* name : {"results/notes.txt", "results/b.txt"}) write(name, "mine");
  for (const Words& more : {Words{}, Words{"--force"}}) {
    const Outcome o = compare(head("heavy_top", "centre") + kTopGrid, more);
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.err.find("it holds 'b.txt' (and 1 more) and is not a result of liesl"),
              std::string::npos)
        << o.err;
  }
  EXPECT_EQ(text_of(results() / "notes.txt"), "mine");
}

TEST_F(Compare, RunsThatStopAreRows) {
  const Outcome o = compare(head("../stability/unequal_masses", "ton") +
                            "[grid]\nstep = [5e-4, 2.5e-4]\n[vary]\n"
                            "rho_inf = { key = \"simulation.rho_inf\", values = [0.5, 0.9] }\n");
  ASSERT_EQ(o.code, 0) << o.err;
  ASSERT_EQ(rows().size(), 4u);
  int stopped = 0;
  for (const Row& row : rows()) {
    if (row.at("status") != "stopped") continue;
    ++stopped;
    EXPECT_NE(row.at("reason"), "");
    EXPECT_EQ(row.at("cpu_s"), "");
  }
  EXPECT_GT(stopped, 0);
  EXPECT_LT(stopped, 4);
  EXPECT_EQ(summary()["ended"]["stopped"], stopped);
}

/// A refactorised tangent is a recovery where it should be constant, and the rule elsewhere.
TEST_F(Compare, WhatIsARecoveryDependsOnTheTangentOfTheFormalism) {
  EXPECT_EQ(compare(head("pendulum", "tip") +
                    "[grid]\nformalism = [\"se3\", \"r3so3\", \"floating\"]\nstep = [5e-3]\n"
                    "[vary]\nend = { key = \"simulation.duration\", values = [0.2] }\n")
                .code,
            0);
  for (const Row& row : rows()) {
    EXPECT_GT(number(row, "tangent_refreshes"), 0) << row.at("formalism");
    EXPECT_EQ(number(row, "rejected_steps"), 0) << row.at("formalism");
    EXPECT_EQ(row.at("status"), row.at("formalism") == "se3" ? "recovered" : "converged");
  }
}

TEST_F(Compare, ComparisonsThatAreNoneAreRefused) {
  const std::string grid = "[grid]\nstep = [1e-3]\n";
  const std::pair<std::string, const char*> wrong[] = {
      {head("pendulum", "tipp") + grid,
       "study.toml:4:12: the scene has no response 'tipp'; expected a response of the scene; hint: "
       "did you mean 'tip'?"},
      {head("pendulum", "tip") + "[grid]\nformalism = [\"se3\", \"clasical\"]\n",
       "study.toml:7:21: 'simulation.formalism' is \"clasical\""},
      {head("pendulum", "tip") + "[grid]\n", "study.toml:6:1: the grid is empty"},
      {head("pendulum", "tip") + "[grid]\nstep = []\n", "study.toml:7:8: 'grid.step' is empty"},
      {head("pendulum", "tip") + "[grid]\nsteps = [1]\n", "did you mean 'step'?"},
      {head("pendulum", "tip", "mean") + grid, "'quantity.norm' is \"mean\""},
      {head("pendulum", "tip") + grid + "[set]\n\"simulation.stp\" = 1\n", "study.toml:9:20: "},
      {head("pendulum", "tip") + grid +
           "[reference]\nformalisms = [\"se3\", \"se3\"]\nstep = 1e-4\n",
       "study.toml:9:14: the reference compares a formalism with itself"},
      {head("pendulum", "tip") + grid +
           "[reference]\nformalisms = [\"se3\", \"r3s3\"]\nstep = 1e-4\n",
       "study.toml:9:22: unknown formalism \"r3s3\"; expected one of"},
      {head("pendulum", "tip") + grid +
           "[reference]\nformalisms = [\"se3\", \"r3so3\"]\nstep = 1e-4\nextrapolate = \"mesh\"\n",
       "study.toml:11:15: the mesh cannot be halved"},
      {head("heavy_top", "centre") + "[grid]\nelements = [2]\n", "the scene has no beam"},
      {head("roll_up", "tip") + grid, "the scene is not dynamic"},
      {"beams = [\"rud\"]\n" + head("slider_crank", "bend") + grid,
       "study.toml:1:10: the scene has no beam 'rud'"},
      {head("pendulum", "tip") + grid + "[vary]\nerror = { key = \"gravity.1\", values = [1] }\n",
       "study.toml:9:17: 'error' is the name of a column"},
  };
  for (const auto& [text, message] : wrong) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(message), std::string::npos) << text << "\n" << said;
  }
  const Outcome failed = compare(head("../stability/unequal_masses", "ton") + grid +
                                 "[reference]\nformalisms = [\"se3\", \"r3so3\"]\nstep = 5e-4\n");
  EXPECT_EQ(failed.code, 2);
  EXPECT_TRUE(failed.err.find("study.toml:8:1: the reference of r3so3 failed: ") !=
                  std::string::npos ||
              failed.err.find("study.toml:8:1: the reference of se3 failed: ") != std::string::npos)
      << failed.err;
  EXPECT_FALSE(fs::exists(results())) << "no row, no folder";
}

/// The second motion of two has no reference; the row of the first stays.
TEST_F(Compare, ARefusalOnTheWayKeepsTheRowsBefore) {
  const Outcome o = compare(head("../stability/unequal_masses", "ton") +
                            "[grid]\nstep = [1e-4]\n[vary]\nend = { key = \"simulation.duration\", "
                            "values = [5e-4, 1] }\n[reference]\nformalisms = [\"se3\", "
                            "\"r3so3\"]\nstep = 5e-4\n");
  EXPECT_EQ(o.code, 2) << o.out;
  EXPECT_EQ(rows().size(), 1u);
  EXPECT_EQ(summary()["status"], "refused");
  EXPECT_NE(summary()["warnings"].back().get<std::string>().find("failed: "), std::string::npos);
}

TEST_F(Compare, IsDrawn) {
  ASSERT_EQ(compare(head("heavy_top", "centre") + kTopReference + kTopGrid).code, 0);
  const Outcome o = run({"plot", results()});
  ASSERT_EQ(o.code, 0) << o.err;
  for (const char* name : {"work_precision", "orders"})
    for (const char* kind : {".png", ".svg"})
      EXPECT_GT(fs::file_size(results() / "plots" / (std::string(name) + kind)), 5000u) << name;
  const Outcome none = run({"plot", results(), "--x", "stp", "--y", "step"});
  EXPECT_EQ(none.code, 3);
  EXPECT_NE(none.err.find("'stp'"), std::string::npos) << none.err;
}

TEST(ShippedComparisons, AreRead) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kData / "studies")) {
    if (entry.path().extension() != ".toml" ||
        kind_of(load_document(entry.path()).root) != FileKind::Comparison)
      continue;
    SCOPED_TRACE(entry.path());
    ++count;
    EXPECT_EQ(entry.path().filename().string().rfind("compare_", 0), 0u);
    EXPECT_GE(load_comparison(entry.path()).rows.cases.rows.size(), 8u);
    EXPECT_NE(text_of(entry.path()).find("Source:"), std::string::npos);
  }
  EXPECT_GE(count, 7);
}

/// A row an optimisation; the plain cycle has one row for all treatments, an optimiser of the
/// motion itself those whose number of constraints stays.
TEST_F(Compare, MethodsAreRows) {
  const std::string text =
      "study = \"" + study("slider_crank_rod") +
      "\"\nset = { \"simulation.duration\" = 0.02, \"constraints.bending.limit\" = 2e-4 }\n"
      "[grid]\nmethod = [\"esl\", \"esl1\", \"full\", \"direct\"]\n"
      "treatment = [\"auto\", \"maxima\"]\n";
  const Outcome o = compare(text);
  ASSERT_EQ(o.code, 0) << o.err;
  const auto rows = read_rows(results() / "rows.csv");
  ASSERT_EQ(rows.size(), 6u);  // esl and direct have one treatment
  EXPECT_EQ(rows[0].at("method"), "esl");
  EXPECT_EQ(rows[1].at("method"), "esl1");
  EXPECT_EQ(rows[5].at("method"), "direct");
  EXPECT_EQ(number(rows[0], "sensitivities"), 1);
  for (const Row& row : rows) {
    EXPECT_LT(number(row, "violation"), 1e-3) << row.at("method");
    EXPECT_GT(number(row, "cpu_s"), 0);
    EXPECT_GE(number(row, "simulations"), number(row, "sensitivities"));
    if (row.at("method") == "esl") continue;
    EXPECT_EQ(row.at("status"), "optimal") << row.at("reason");
    EXPECT_LE(number(row, "kkt"), 1e-2);
    EXPECT_NEAR(number(row, "mass"), number(rows[1], "mass"), 1e-3 * number(rows[1], "mass"))
        << "one optimum, whatever the way";
  }
  const Outcome optimum =
      run({"optimize", study("slider_crank_rod"), "-q", "--no-report", "-o", dir_ / "optimum",
           "--set", "simulation.duration=0.02", "--set", "constraints.bending.limit=2e-4", "--set",
           "cycle.method=full", "--set", "cycle.refine=never"});
  ASSERT_EQ(optimum.code, 0) << optimum.err;
  const Json figures = Json::parse(text_of(dir_ / "optimum" / "summary.json"));
  EXPECT_EQ(rows[3].at("method"), "full");
  EXPECT_DOUBLE_EQ(number(rows[3], "mass"), figures["mass_final"].get<double>());
  EXPECT_DOUBLE_EQ(number(rows[3], "simulations"), figures["history"].size());
  EXPECT_EQ(keys(summary()), documented("### `compare`").always);
  EXPECT_EQ(run({"plot", results()}).code, 0);
  EXPECT_TRUE(fs::exists(results() / "plots" / "methods.png"));
}

/// With aggregates over time alone "esl1" has no static problem left: its row is that of "full" to
/// the last digit, and stands there only if "full" does not.
TEST_F(Compare, AggregatedLimitsHaveOneRowOfTwoMethods) {
  const auto row_of = [&](const std::string& method) {
    const Outcome o = compare(
        "study = \"" + study("slider_crank_rod") +
        "\"\nset = { \"simulation.duration\" = 0.02, \"constraints.bending.limit\" = 2e-4 }\n"
        "[grid]\nmethod = [\"" +
        method + "\"]\ntreatment = [\"ks\"]\n");
    EXPECT_EQ(o.code, 0) << o.err;
    const auto rows = read_rows(results() / "rows.csv");
    EXPECT_EQ(rows.size(), 1u);
    return rows.at(0);
  };
  const Row esl1 = row_of("esl1");
  fs::remove_all(results());
  const Row full = row_of("full");
  for (const char* column : {"status", "simulations", "sensitivities", "mass", "violation", "kkt"})
    EXPECT_EQ(esl1.at(column), full.at(column)) << column;
}

TEST_F(Compare, RefusesWhatMethodsHaveNot) {
  const std::string head = "study = \"" + study("slider_crank_rod") + "\"\n";
  const auto refused = [&](const std::string& text, const char* why) {
    const Outcome o = compare(text);
    EXPECT_EQ(o.code, 2) << why;
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("study.toml:"), std::string::npos) << "the place: " << o.err;
  };
  refused(head + "[grid]\nmethod = [\"esl2\"]\n", "esl2");
  refused(head + "[grid]\nmethod = [\"esl1\"]\ntreatment = [\"mean\"]\n", "mean");
  refused(head + "[grid]\nformalism = [\"se3\"]\n", "a study has no formalism");
  refused(head + "[quantity]\nresponse = \"bend\"\n[grid]\nmethod = [\"esl\"]\n",
          "a study has no quantity");
  refused(head +
              "[grid]\nmethod = [\"esl1\"]\n[vary]\nr = { key = \"cycle.refine\", values = "
              "[\"auto\"] }\n",
          "methods are compared on one");
  refused("study = \"" + study("cantilever") + "\"\n[grid]\nmethod = [\"esl1\"]\n",
          "the study has no motion");
  refused("scene = \"" + scene("slider_crank") +
              "\"\n[quantity]\nresponse = \"bend\"\n[grid]\nmethod = [\"esl\"]\n",
          "a scene has no method");
  refused("scene = \"" + scene("slider_crank") + "\"\n[grid]\nformalism = [\"se3\"]\n",
          "missing key 'quantity'");
}

}  // namespace
}  // namespace liesl::test::compare_test
