/// What liesl did not write it neither replaces nor removes.

#include "apps/output/own_files.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <iterator>
#include <thread>

#include "apps/batch/case_folder.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "tests/apps/output_sample.hpp"

namespace fs = std::filesystem;

namespace liesl::test::own_files_test {
namespace {

using namespace output;

using Names = std::vector<std::string>;

const std::string kSummary = R"({"status": "done", "versions": {"liesl": "0.1.0"}})";

/// A file with its folders.
void put(const fs::path& path, const std::string& text = "text") {
  fs::create_directories(path.parent_path());
  write_file(path, text);
}

void write_result(const fs::path& target, const std::string& data, bool overwrite = false) {
  AtomicFolder folder(target, overwrite);
  put(folder.path() / "summary.json", kSummary);
  put(folder.path() / "rod.svg", data);
  folder.commit();
}

std::string refusal(const fs::path& target, bool overwrite = true) {
  try {
    AtomicFolder folder(target, overwrite);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(OwnFiles, PartsOfKilledProcessesGo) {
  const TemporaryFolder place;
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  const std::string left = ".summary.json.part-" + std::to_string(gone);
  const std::string in_work = ".summary.json.part-" + std::to_string(::getpid());
  for (const std::string& name : {left, in_work, std::string(".notes.part-two")}) put(place / name);
  remove_parts(place.path());
  EXPECT_FALSE(fs::exists(place / left));
  EXPECT_TRUE(fs::exists(place / in_work));
  EXPECT_TRUE(fs::exists(place / ".notes.part-two")) << "no name of ours";
}

/// A drawing that was killed: before its first picture (an empty folder), or among its pictures.
TEST(OwnFiles, PicturesOfKilledDrawingsAreReplaced) {
  const TemporaryFolder place;
  write_result(place / "out", "1");
  fs::create_directory(place / "out/plots");
  put(place / "out/.plots.part-12345/design.png");
  EXPECT_EQ(foreign_files(place / "out"), Names());
  write_result(place / "out", "2", true);
  EXPECT_FALSE(fs::exists(place / "out/plots"));
  EXPECT_FALSE(fs::exists(place / "out/.plots.part-12345"));
  put(place / "out/plots/mine.png");
  EXPECT_EQ(foreign_files(place / "out"), Names{"plots/mine.png"});
  fs::remove_all(place / "out/plots");
  put(place / "out/plots");  // a file
  EXPECT_EQ(foreign_files(place / "out"), Names{"plots"});
}

TEST(OwnFiles, AreThoseOfTheMark) {
  const TemporaryFolder place;
  write_result(place / "out", "1");
  EXPECT_TRUE(is_result(place / "out"));
  EXPECT_TRUE(foreign_files(place / "out").empty());
  // Names of docs/outputs.md that this run did not write, a folder with a file, and an empty one.
  put(place / "out/responses.csv");
  put(place / "out/photos/1.jpg");
  fs::create_directory(place / "out/later");
  EXPECT_EQ(foreign_files(place / "out"), (Names{"later", "photos/1.jpg", "responses.csv"}));
  mark_files(place / "out", {"plots/design.png"});
  put(place / "out/plots/design.png");
  put(place / "out/plots/mine.png");
  EXPECT_EQ(foreign_files(place / "out"),
            (Names{"later", "photos/1.jpg", "plots/mine.png", "responses.csv"}));
}

TEST(OwnFiles, FolderWithAnythingElseIsRefusedByName) {
  const TemporaryFolder place;
  write_result(place / "out", "1");
  put(place / "out/scene.toml");
  const std::string one = refusal(place / "out");
  EXPECT_NE(one.find("'scene.toml', which liesl did not write"), std::string::npos) << one;
  put(place / "out/notes.txt");
  const std::string two = refusal(place / "out");
  EXPECT_NE(two.find("'notes.txt' (and 1 more)"), std::string::npos) << two;
  EXPECT_EQ(read_file(place / "out/notes.txt"), "text");
  EXPECT_EQ(read_file(place / "out/rod.svg"), "1");
  fs::remove(place / "out/notes.txt");
  fs::remove(place / "out/scene.toml");
  write_result(place / "out", "2", true);
  EXPECT_EQ(read_file(place / "out/rod.svg"), "2");
}

TEST(OwnFiles, OfResultsWithoutMarkHaveTheDocumentedNames) {
  const TemporaryFolder place;
  for (const char* name : {"summary.json", "results.h5", "responses.csv", "plots/energies.png",
                           "rod.vtu", "rod.svg", "rod_outline.toml"})
    put(place / "old" / name, kSummary);
  EXPECT_TRUE(is_result(place / "old"));
  EXPECT_TRUE(foreign_files(place / "old").empty());
  // A drawing beside no part, and the scene.
  put(place / "old/sketch.svg");
  put(place / "old/scene.toml");
  EXPECT_EQ(foreign_files(place / "old"), (Names{"scene.toml", "sketch.svg"}));
  mark_files(place / "old", {"plots/design.png"});
  EXPECT_EQ(foreign_files(place / "old"), (Names{"scene.toml", "sketch.svg"}));
}

TEST(OwnFiles, WhatIsPutIntoAFolderDuringARunStays) {
  const TemporaryFolder place;
  AtomicFolder folder(place / "out", false);
  for (const char* state : {"1", "2", "3"}) {
    put(folder.path() / "summary.json", kSummary);
    if (state[0] == '3') put(folder.path() / "notes.txt", "of liesl");
    folder.commit();
    put(place / "out/notes.txt", "mine");
    put(place / "out/photos/1.jpg");
    if (state[0] == '1') continue;
    EXPECT_EQ(read_file(place / "out/photos/1.jpg"), "text");
  }
  EXPECT_TRUE(fs::exists(place / "out/notes.txt~")) << "the name that a later state takes";
  EXPECT_EQ(read_file(place / "out/notes.txt~"), "mine");
}

TEST(OwnFiles, OfABatchAreThoseOfItsCases) {
  const TemporaryFolder place;
  const fs::path batch = place / "out";
  put(batch / ".lock", "");
  mark_files(batch, {".lock", "batch.json", "cases", "results.csv", "summary.json"});
  put(batch / "batch.json", R"({"input_sha256": "0", "cases": {"1": [], "2": []}})");
  write_result(batch / "cases/1", "1");
  mark_files(batch / "cases/1", {"done.json"});
  for (const char* name : {"cases/1/done.json", "cases/2/done.json", "cases/2/log.txt",
                           "cases/.2.log", "cases/.2.partial-1@host/summary.json"})
    put(batch / name);
  EXPECT_TRUE(foreign_files(batch).empty());
  put(batch / "cases/1/notes.txt");
  put(batch / "cases/3/done.json");
  EXPECT_EQ(foreign_files(batch), (Names{"cases/1/notes.txt", "cases/3/done.json"}));
  EXPECT_THROW(check_own(batch), IoError);
  remove_own(batch, ".lock");
  EXPECT_EQ(foreign_files(batch), (Names{".lock", "cases/1/notes.txt", "cases/3/done.json"}));
  EXPECT_FALSE(fs::exists(batch / "cases/2"));
}

TEST(Alone, SecondRunIntoOneFolderIsRefusedByName) {
  const TemporaryFolder place;
  for (const bool committed : {false, true}) {
    std::array<int, 2> begun, over;
    ASSERT_EQ(::pipe(begun.data()) + ::pipe(over.data()), 0);
    const pid_t first = ::fork();
    if (first == 0) {
      ::close(over[1]);
      {
        AtomicFolder folder(place / "out", false);
        put(folder.path() / "summary.json", kSummary);
        if (committed) folder.commit();
        char byte = 'x';
        (void)!::write(begun[1], &byte, 1);
        (void)!::read(over[0], &byte, 1);
      }
      ::_exit(0);
    }
    ::close(over[0]);
    char byte = 0;
    ASSERT_EQ(::read(begun[0], &byte, 1), 1);
    const std::string text = refusal(place / "out");
    EXPECT_NE(text.find("process " + std::to_string(first) + " is writing to it"),
              std::string::npos)
        << text;
    EXPECT_EQ(refusal(place / "other"), "") << "another folder in the same place";
    ::close(over[1]);
    ::waitpid(first, nullptr, 0);
    EXPECT_EQ(refusal(place / "out"), "") << "it has ended";
  }
}

TEST(Alone, LeftoversOfKilledRunsInTheSamePlaceGo) {
  const TemporaryFolder place;
  const pid_t killed = ::fork();
  if (killed == 0) {
    AtomicFolder folder(place / "first", false);
    put(folder.path() / "data");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(killed, nullptr, 0);
  // Of another computer, whose processes cannot be seen; of somebody else.
  put(place / ".far.partial-1@elsewhere/data");
  put(place / ".mine.partial-view/data");
  ASSERT_EQ(std::distance(fs::directory_iterator(place.path()), {}), 3);
  write_result(place / "second", "1");
  EXPECT_EQ(std::distance(fs::directory_iterator(place.path()), {}), 3);
  EXPECT_TRUE(fs::exists(place / ".far.partial-1@elsewhere/data"));
  EXPECT_TRUE(fs::exists(place / ".mine.partial-view/data"));
}

/// A run of another version, or of Python, has another name; a program that began after the folder
/// was last changed has only the number of a run that is gone.
TEST(Alone, FoldersOfProgramsOfAnotherNameStayWhileTheyMayWrite) {
  using namespace std::chrono_literals;
  const TemporaryFolder place;
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const auto other_program = [] {
    const pid_t child = ::fork();
    if (child == 0) ::execlp("sleep", "sleep", "60", nullptr);
    return child;
  };
  const auto folder_of = [&](const std::string& name, pid_t pid) {
    return place / ("." + name + ".partial-" + std::to_string(pid) + "@" + host.data());
  };
  const pid_t writer = other_program();
  std::this_thread::sleep_for(100ms);  // it is `sleep` now
  put(folder_of("writing", writer) / "data");
  put(place / "later/data");
  fs::last_write_time(place / "later", fs::file_time_type::clock::now() - 2min);
  const pid_t later = other_program();
  std::this_thread::sleep_for(100ms);
  fs::rename(place / "later", folder_of("gone", later));  // of the process that had its number
  write_result(place / "out", "1");
  EXPECT_TRUE(fs::exists(folder_of("writing", writer) / "data"));
  EXPECT_FALSE(fs::exists(folder_of("gone", later)));
  for (const pid_t pid : {writer, later}) {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
  }
  write_result(place / "again", "1");
  EXPECT_FALSE(fs::exists(folder_of("writing", writer)));
}

TEST(CaseEnd, OfAFullDiskIsTriedAgain) {
  const TemporaryFolder place;
  const CaseFolder folder(place.path(), "1");
  WorkerEnd end;
  end.exit_code = 3;
  put(place / "cases/.1.log", "liesl: cannot write 'x': the disk is full (no space); make room");
  const CaseEnd full = folder.judge(end, {});
  EXPECT_EQ(full.status, "disk full");
  EXPECT_TRUE(full.failed && full.tried_again());
  put(place / "cases/.1.log", "liesl: cannot write 'x': Disk quota exceeded");
  EXPECT_EQ(folder.judge(end, {}).status, "not written");
  EXPECT_TRUE(folder.judge(end, {}).tried_again());
  put(place / "cases/.1.log", "liesl: out of memory; use fewer elements");
  EXPECT_EQ(folder.judge(end, {}).status, "no memory");
  EXPECT_TRUE(folder.judge(end, {}).tried_again());
  EXPECT_FALSE(folder.judge(end, {{}, 64.0}).tried_again()) << "the batch's own limit";
  put(place / "cases/.1.log", "liesl: internal error: no");
  const CaseEnd failed = folder.judge(end, {});
  EXPECT_EQ(failed.status, "failed");
  EXPECT_FALSE(failed.tried_again());
  end.exit_code = 127;
  put(place / "cases/.1.log", "");
  EXPECT_EQ(folder.judge(end, {}).status, "not started");
  EXPECT_TRUE(folder.judge(end, {}).tried_again());
}

}  // namespace
}  // namespace liesl::test::own_files_test
