/// @file
/// `liesl batch` as a user runs it: what it leaves, how it goes on, and what failures become.
#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "apps/batch/case_folder.hpp"
#include "apps/batch/case_table.hpp"
#include "apps/batch/pool.hpp"
#include "apps/hdf5_set.hpp"
#include "apps/program.hpp"
#include "mbs/linalg/sanitized.hpp"

namespace liesl::test::batch_test {
namespace {

class BatchProgram : public Program {
 protected:
  /// Six short simulations of the slider-crank.
  fs::path simulations(const std::string& more = "") const {
    return write("batch.toml",
                 "name = \"six\"\nscene = \"" + scene("slider_crank") +
                     "\"\n[grid]\n"
                     "rate = { key = \"joints.motor.drive.rate\", values = [50, 100, 150] }\n"
                     "step = { key = \"simulation.step\", values = [1e-3, 5e-4] }\n" +
                     more);
  }
  /// Sizings of the rod that take some cycles each.
  fs::path sizings() const {
    return write("batch.toml", "study = \"" + study("slider_crank_rod") +
                                   "\"\n[grid]\n"
                                   "limit = { key = \"constraints.bending.limit\", values = "
                                   "[6e-4, 7e-4, 8e-4, 9e-4, 1e-3, 1.1e-3] }\n");
  }
  Outcome batch(const fs::path& file, const Words& more = {}) const {
    Words words = {"batch", file, "-o", results()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// results.csv by columns.
  std::map<std::string, Words> table() const {
    liesl::Problems problems("results.csv");
    const auto rows = liesl::read_csv(text_of(results() / "results.csv"), "", problems);
    std::map<std::string, Words> columns;
    for (std::size_t c = 0; c < rows.at(0).size(); ++c)
      for (std::size_t r = 1; r < rows.size(); ++r)
        columns[rows[0][c].text].push_back(rows[r][c].text);
    return columns;
  }
  fs::path mark(const std::string& name) const { return results() / "cases" / name / "done.json"; }
  std::set<std::string> marks() const {
    std::set<std::string> names;
    if (!fs::exists(results() / "cases")) return names;
    for (const auto& entry : fs::directory_iterator(results() / "cases"))
      if (fs::exists(entry.path() / "done.json")) names.insert(entry.path().filename());
    return names;
  }
  /// Until as many cases have their mark, or the time is over.
  bool wait_for_marks(std::size_t count) const {
    for (int i = 0; i < 30000 && marks().size() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return marks().size() >= count;
  }
  /// Processes that a process has started.
  static std::vector<pid_t> children(pid_t parent) {
    std::istringstream list(text_of("/proc/" + std::to_string(parent) + "/task/" +
                                    std::to_string(parent) + "/children"));
    std::vector<pid_t> pids;
    for (pid_t pid; list >> pid;) pids.push_back(pid);
    return pids;
  }
  pid_t wait_for_child(pid_t parent) const {
    for (int i = 0; i < 5000 && children(parent).empty(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return children(parent).empty() ? 0 : children(parent).front();
  }
};

TEST_F(BatchProgram, EveryCaseIsTheCommandByHand) {
  const Outcome o = batch(simulations());
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.err, "");
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_EQ(summary()["ended"], Json({{"done", 6}}));
  EXPECT_EQ(summary()["input_units"], Json({{"step", "s"}}));
  const auto columns = table();
  EXPECT_EQ(text_of(results() / "results.csv").substr(0, 28), "case,rate,step,status,reason");
  EXPECT_EQ(columns.at("case"), (Words{"1", "2", "3", "4", "5", "6"}));
  EXPECT_EQ(columns.at("rate"), (Words{"50", "50", "100", "100", "150", "150"}));

  const fs::path by_hand = dir_ / "by_hand";
  ASSERT_EQ(run({"run", scene("slider_crank"), "-o", by_hand, "--set",
                 "joints.motor.drive.rate=100", "--set", "simulation.step=5e-4"})
                .code,
            0);
  EXPECT_EQ(text_of(by_hand / "responses.csv"),
            text_of(results() / "cases" / "4" / "responses.csv"));
  const Json single = Json::parse(text_of(by_hand / "summary.json"));
  EXPECT_EQ(std::stod(columns.at("bend.max_abs [m]")[3]), single["responses"]["bend"]["max_abs"]);
  EXPECT_EQ(std::stod(columns.at("steps [-]")[3]), single["steps"]);
}

/// The process of a pool that was killed holds its case until it is gone: here until another case
/// has ended. What is held all the time runs elsewhere.
TEST_F(BatchProgram, ACaseThatRanElsewhereIsAskedForOnceMore) {
  const Batch six = load_batch(simulations());
  PoolOptions options;
  options.quiet = true;
  options.reports = false;
  std::optional<CaseLock> other(std::in_place, CaseFolder(results(), "1"));
  ASSERT_TRUE(other->held());
  const PoolReport first = run_cases(six, results(), options);
  EXPECT_EQ(first.ran, 5);
  EXPECT_EQ(first.elsewhere, 1);
  fs::remove_all(mark("6").parent_path());
  options.on_end = [&other](const PoolReport&) { other.reset(); };
  const PoolReport second = run_cases(six, results(), options);
  EXPECT_EQ(second.ran, 2);
  EXPECT_EQ(second.elsewhere, 0);
  EXPECT_EQ(marks().size(), 6u);
}

TEST_F(BatchProgram, ShardsAreThePartsOfTheWhole) {
  const fs::path file = simulations();
  EXPECT_EQ(batch(file, {"--shard", "2/3"}).code, 0);
  EXPECT_EQ(marks(), (std::set<std::string>{"2", "5"}));
  EXPECT_EQ(summary()["status"], "incomplete");
  EXPECT_EQ(table().at("case"), (Words{"2", "5"}));
  EXPECT_FALSE(fs::exists(results() / "results.h5"));
  const pid_t one = start({"batch", file, "-o", results(), "--shard", "1/3"});
  EXPECT_EQ(batch(file, {"--shard", "3/3"}).code, 0);
  EXPECT_EQ(wait_for(one).code, 0);
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_EQ(table().at("case").size(), 6u);
  EXPECT_TRUE(fs::exists(results() / "results.h5"));
}

/// Several pools in one folder, begun at once: every case is run by one of them.
TEST_F(BatchProgram, PoolsShareAFolder) {
  const fs::path file = simulations();
  std::vector<pid_t> pools;
  for (const char* tag : {"0", "1", "2", "3"})
    pools.push_back(start({"batch", file, "-o", results(), "-j", "2"}, tag));
  int ran = 0;
  for (std::size_t i = 0; i < pools.size(); ++i) {
    const Outcome o = wait_for(pools[i], std::to_string(i));
    EXPECT_EQ(o.code, 0) << o.err;
    std::smatch now;
    ASSERT_TRUE(std::regex_search(o.out, now, std::regex(" ([0-9]+) cases? now,"))) << o.out;
    ran += std::stoi(now[1]);
  }
  EXPECT_EQ(ran, 6);
  EXPECT_EQ(summary()["status"], "done") << summary()["reason"];
  EXPECT_EQ(table().at("case").size(), 6u);
  for (const auto& entry : fs::directory_iterator(results() / "cases"))
    EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
}

TEST_F(BatchProgram, FinishedCasesAreNotRunAgain) {
  const fs::path file = simulations();
  ASSERT_EQ(batch(file).code, 0);
  const auto before = fs::last_write_time(mark("3"));
  const std::string first = text_of(results() / "results.csv");
  const Outcome o = batch(file);
  EXPECT_EQ(o.code, 0);
  EXPECT_NE(o.out.find("0 cases now, 6 before"), std::string::npos) << o.out;
  EXPECT_EQ(fs::last_write_time(mark("3")), before);
  EXPECT_EQ(text_of(results() / "results.csv"), first);

  EXPECT_EQ(batch(simulations("[limits]\ntime = 60\n")).code, 0) << "the cases are the same";

  fs::remove(mark("3"));  // killed between the end of the case and its mark
  const auto result = fs::last_write_time(results() / "cases" / "3" / "responses.csv");
  EXPECT_EQ(batch(file).code, 0);
  EXPECT_TRUE(fs::exists(mark("3")));
  EXPECT_EQ(fs::last_write_time(results() / "cases" / "3" / "responses.csv"), result);
}

TEST_F(BatchProgram, FoldersOfOthersAreRefused) {
  fs::create_directory(dir_ / "photos");
  for (const char* name : {"photos/b.jpg", "photos/a.jpg"}) write(name, "picture");
  const fs::path file = simulations();
  ASSERT_EQ(batch(file, {"--set", "simulation.duration=0.01"}).code, 0);
  EXPECT_EQ(batch(file, {"--set", "grid.step.values=[1e-3, 6e-4]"}).code, 2);
  const Outcome o = batch(file);
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.err.find("belongs to another batch"), std::string::npos) << o.err;
  EXPECT_EQ(batch(file, {"--shard", "1/2", "--force"}).code, 2);
  EXPECT_EQ(batch(file, {"--force", "--set", "simulation.duration=0.02"}).code, 0);
  EXPECT_EQ(batch(file, {"--shard", "7/6"}).code, 2);
  const Outcome of_others = run({"batch", file, "-o", dir_ / "photos"});
  EXPECT_EQ(of_others.code, 3) << "a folder that holds something else";
  EXPECT_NE(of_others.err.find("it holds 'a.jpg' (and 1 more), but no batch"), std::string::npos)
      << of_others.err;
}

TEST_F(BatchProgram, FilesOfTheUserStay) {
  const fs::path file = simulations();
  const Words fewer = {"--set", "grid.rate.values=[100]", "--set", "simulation.duration=0.01"};
  ASSERT_EQ(batch(file, fewer).code, 0);
  std::ofstream(results() / "cases" / "1" / "notes.txt") << "mine";
  Words force = fewer;
  force.push_back("--force");
  const Outcome o = batch(file, force);
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("'cases/1/notes.txt', which liesl did not write"), std::string::npos)
      << o.err;
  EXPECT_EQ(text_of(results() / "cases" / "1" / "notes.txt"), "mine");
  EXPECT_EQ(marks().size(), 2u) << "nothing has been removed";
  fs::remove(results() / "cases" / "1" / "notes.txt");
  EXPECT_EQ(batch(file, force).code, 0);
}

TEST_F(BatchProgram, CaseThatFailedByAFullDiskIsTriedAgain) {
  const fs::path file = simulations();
  const Words fewer = {"--set", "grid.rate.values=[100]", "--set", "simulation.duration=0.01"};
  ASSERT_EQ(batch(file, fewer).code, 0);
  const auto ended = [this](const char* status) {
    std::ofstream(mark("1")) << Json{
        {"case", "1"}, {"status", status}, {"failed", true}, {"figures", false}, {"reason", "so"}};
    for (const auto& name : {"summary.json", "responses.csv"})
      fs::remove(results() / "cases" / "1" / name);
  };
  ended("failed");
  EXPECT_EQ(batch(file, fewer).code, 1) << "of the case itself: it would fail again";
  EXPECT_EQ(table().at("status"), (Words{"failed", "done"}));
  ended("disk full");
  EXPECT_EQ(batch(file, fewer).code, 0);
  EXPECT_EQ(table().at("status"), (Words{"done", "done"}));
}

/// Emptied and mistyped files are no results: their cases are run again, or they are named.
TEST_F(BatchProgram, DamagedFilesAreNoResults) {
  const fs::path file = simulations();
  const Words fewer = {"--set", "grid.rate.values=[100]", "--set", "simulation.duration=0.01"};
  ASSERT_EQ(batch(file, fewer).code, 0);
  const fs::path first = results() / "cases" / "1" / "summary.json";
  const std::string steps = table().at("steps [-]")[0];
  for (const std::string text : {"", "[1]", R"({"status": 3})", R"({"st)"})
    for (const fs::path& damaged : {mark("1"), first}) {
      std::ofstream(damaged) << text;
      const Outcome o = batch(file, fewer);
      EXPECT_EQ(o.code, 0) << damaged << text << o.err;
      EXPECT_EQ(table().at("status"), (Words{"done", "done"}));
      EXPECT_EQ(table().at("steps [-]")[0], steps) << "its figures are back";
    }
  std::ofstream(first) << R"({"status": "done", "responses": [1]})";
  const Outcome o = batch(file, fewer);
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("cases/1/summary.json': it is no summary of liesl"), std::string::npos)
      << o.err;
  std::ofstream(results() / "batch.json") << R"({"input_sha256": 4})";
  EXPECT_EQ(batch(file, fewer).code, 2);
}

/// Nothing lost, nothing twice, and the same designs as without a kill.
TEST_F(BatchProgram, KilledBatchGoesOn) {
  const fs::path file = sizings();
  ASSERT_EQ(run({"batch", file, "-o", dir_ / "whole", "-j", "2", "--no-verify"}).code, 0);

  const pid_t pool = start({"batch", file, "-o", results(), "-j", "2", "--no-verify"});
  ASSERT_TRUE(wait_for_marks(2));
  const auto workers = children(pool);
  kill(pool, SIGKILL);
  ASSERT_EQ(wait_for(pool).code, -SIGKILL) << "it was done before";
  for (const pid_t worker : workers)  // they die with it
    for (int i = 0; i < 2000 && kill(worker, 0) == 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  for (const pid_t worker : workers) EXPECT_NE(kill(worker, 0), 0);
  const auto before = marks();
  ASSERT_LT(before.size(), 6u);
  std::map<std::string, fs::file_time_type> times;
  for (const auto& name : before) {
    times[name] = fs::last_write_time(mark(name));
    std::ofstream(results() / "cases" / ("." + name + ".log"));  // killed behind the mark
  }

  const Outcome o = batch(file, {"-j", "2", "--no-verify"});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(marks().size(), 6u);
  for (const auto& [name, time] : times) EXPECT_EQ(fs::last_write_time(mark(name)), time) << name;
  const Words masses = table().at("mass_final [kg]");
  for (int k = 0; k < 6; ++k) {
    const Json whole =
        Json::parse(text_of(dir_ / "whole/cases" / std::to_string(k + 1) / "summary.json"));
    EXPECT_NEAR(std::stod(masses[k]), whole["mass_final"], 1e-5 * double(whole["mass_final"]));
  }
  for (const auto& entry : fs::directory_iterator(results() / "cases"))
    EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
}

/// Its table and summary are there, without a case and with the first ones; the page is of them.
TEST_F(BatchProgram, KilledBatchHasItsTable) {
  const fs::path file = sizings();
  const pid_t pool = start({"batch", file, "-o", results(), "-j", "1", "--no-verify"});
  ASSERT_NE(wait_for_child(pool), 0);  // the first case
  EXPECT_EQ(summary()["status"], "running");
  EXPECT_EQ(summary()["reason"],
            "0 of 6 cases have ended so far; the same command goes on with the rest");
  EXPECT_EQ(run({"report", results()}).code, 0);
  ASSERT_TRUE(wait_for_marks(2));  // the table has the first one by then
  kill(pool, SIGKILL);
  ASSERT_EQ(wait_for(pool).code, -SIGKILL) << "it was done before";
  EXPECT_EQ(summary()["status"], "running");
  EXPECT_GE(table().at("case").size(), 1u);
  EXPECT_EQ(table().at("status")[0], "optimal");
  // Killed between the two, the table has one more: it is written first.
  const int rows = static_cast<int>(table().at("case").size()), done = summary()["done"];
  EXPECT_TRUE(rows == done || rows == done + 1) << rows << " rows, " << done << " done";
  EXPECT_EQ(run({"report", results()}).code, 0);
  fs::remove(results() / "summary.json");  // of an earlier version, that wrote it at the end
  for (const char* command : {"report", "plot"}) {
    const Outcome o = run({command, results()});
    EXPECT_EQ(o.code, 3);
    EXPECT_NE(o.err.find("its batch has not written a table yet; the same `liesl batch` goes on"),
              std::string::npos)
        << o.err;
  }
}

TEST_F(BatchProgram, InterruptedBatchGoesOn) {
  const fs::path file = sizings();
  const pid_t pool = start({"batch", file, "-o", results(), "-j", "2", "--no-verify"});
  ASSERT_TRUE(wait_for_marks(1));
  kill(pool, SIGINT);
  const Outcome o = wait_for(pool);
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_EQ(summary()["status"], "interrupted");
  const std::size_t before = marks().size();
  EXPECT_LT(before, 6u);
  EXPECT_EQ(table().at("case").size(), before);
  EXPECT_EQ(batch(file, {"--no-verify"}).code, 0);
  EXPECT_EQ(summary()["status"], "done");
}

TEST_F(BatchProgram, CrashIsOneFailedRow) {
  const fs::path file = sizings();
  const pid_t pool = start({"batch", file, "-o", results(), "-j", "1", "--no-verify"});
  const pid_t worker = wait_for_child(pool);
  ASSERT_NE(worker, 0);
  kill(worker, SIGSEGV);
  const Outcome o = wait_for(pool);
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(summary()["status"], "some failed");
  EXPECT_EQ(summary()["failed"], 1);
  const auto columns = table();
  EXPECT_EQ(columns.at("status")[0], "crashed");
  EXPECT_EQ(columns.at("reason")[0], "signal 11: Segmentation fault");
  EXPECT_EQ(columns.at("mass_final [kg]")[0], "");
  EXPECT_EQ(std::count(columns.at("status").begin(), columns.at("status").end(), "optimal"), 5);
  EXPECT_NE(o.err.find("case 1: crashed"), std::string::npos) << o.err;
}

TEST_F(BatchProgram, TimeOutIsOneFailedRow) {
  const Outcome o = batch(simulations("[limits]\ntime = 0.3\n"),
                          {"--set", "grid.rate.values=[150]", "--set", "simulation.duration=50",
                           "--set", "grid.step.values=[1e-4]"});
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(table().at("status"), Words{"time-out"});
  EXPECT_EQ(table().at("reason"), Words{"stopped after limits.time = 0.3 s"});
  EXPECT_LT(std::stod(table().at("wall_s [s]")[0]), 5);
}

#ifndef LIESL_SANITIZED  // its shadow memory alone is more than any limit
/// 500 000 steps of records need 4.6 GB.
TEST_F(BatchProgram, OutOfMemoryIsOneFailedRow) {
  const Outcome o = batch(simulations("[limits]\nmemory = 700\n"),
                          {"--set", "grid.rate.values=[150]", "--set", "simulation.duration=50",
                           "--set", "grid.step.values=[1e-4]"});
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(table().at("status"), Words{"out of memory"}) << table().at("reason")[0];
  EXPECT_EQ(table().at("reason"), Words{"needs more than limits.memory = 700 MB"});
}
#endif

TEST_F(BatchProgram, FailuresAreRowsWithReasons) {
  EXPECT_EQ(batch(simulations(),
                  {"--set", "grid.rate.values=[100, 1e7]", "--set", "grid.step.values=[1e-3]"})
                .code,
            1);
  EXPECT_EQ(table().at("status")[0], "done");
  EXPECT_EQ(table().at("status")[1], "not_converged");
  EXPECT_NE(table().at("reason")[1], "");
}

/// Of cases of a study, whose errors of limits take two runs more.
TEST_F(BatchProgram, NoVerifyLeavesErrorsOfLimitsOut) {
  const fs::path file =
      write("sizes.toml", "name = \"sizes\"\nstudy = \"" + study("slider_crank_rod") +
                              "\"\n[grid]\n"
                              "limit = { key = \"constraints.bending.limit\", values = [1e-3] }\n");
  const Words quick = {"--set", "cycle.method=esl", "--set", "simulation.duration=0.02"};
  Words words = quick;
  words.push_back("--no-verify");
  batch(file, words);
  EXPECT_EQ(table().at("status").size(), 1u);
  EXPECT_FALSE(table().contains("worst_constraint_error [-]"));
  words = quick;
  words.push_back("--force");
  batch(file, words);
  EXPECT_TRUE(table().contains("worst_constraint_error [-]"));
}

/// Everything of every case is in one file.
TEST_F(BatchProgram, Hdf5HoldsTheTableAndTheCases) {
  ASSERT_EQ(batch(simulations(), {"--set", "grid.rate.values=[100, 1e7]"}).code, 1);
  const fs::path file = results() / "results.h5";
  const auto columns = table();
  EXPECT_EQ(read_set(file, "/inputs/rate").values, (std::vector<double>{100, 100, 1e7, 1e7}));
  const auto largest = read_set(file, "/figures/bend.max_abs").values;
  ASSERT_EQ(largest.size(), 4u);
  EXPECT_EQ(largest[1], std::stod(columns.at("bend.max_abs [m]")[1]));
  for (const char* name : {"1", "2"}) {
    const std::string inside = std::string("/cases/") + name;
    for (const char* set : {"/bodies/rod/position", "/responses/bend", "/time"}) {
      const auto copy = read_set(file, inside + set);
      const auto own = read_set(results() / "cases" / name / "results.h5", set);
      EXPECT_FALSE(own.values.empty()) << set;
      EXPECT_EQ(copy.values, own.values) << inside << set;
      EXPECT_EQ(copy.shape, own.shape) << inside << set;
    }
  }
}

TEST_F(BatchProgram, SummaryHasTheDocumentedKeys) {
  ASSERT_EQ(batch(simulations()).code, 0);
  EXPECT_EQ(keys(summary()), documented("### `batch`\n").always);
  EXPECT_EQ(keys(Json::parse(text_of(mark("1")))), documented("### Marks").always);
}

TEST_F(BatchProgram, DrawsAnyPairOfColumns) {
  ASSERT_EQ(batch(simulations()).code, 0);
  const Outcome o = run({"plot", results(), "--x", "rate", "--y", "bend.max_abs"});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_TRUE(fs::exists(results() / "plots" / "bend.max_abs_over_rate.png")) << o.out;
  const Outcome wrong = run({"plot", results(), "--x", "rat", "--y", "steps"});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_NE(wrong.err.find("'rate'"), std::string::npos) << wrong.err;
  EXPECT_EQ(run({"plot", results(), "--x", "rate"}).code, 2) << "no --y";
}

}  // namespace
}  // namespace liesl::test::batch_test
