/// A results folder holds a complete state at every moment.

#include "apps/output/atomic_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "tests/apps/output_sample.hpp"

namespace fs = std::filesystem;

namespace liesl::test::atomic_folder_test {
namespace {

using namespace output;

const std::string kSummary = R"({"status": "done", "versions": {"liesl": "0.1.0"}})";

/// Names of everything in a folder, hidden ones too, sorted.
std::vector<std::string> names(const fs::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    found.push_back(entry.path().filename().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Writes and commits a result with one data file.
void write_result(const fs::path& target, const std::string& data, bool overwrite = false) {
  AtomicFolder folder(target, overwrite);
  write_file(folder.path() / "summary.json", kSummary);
  write_file(folder.path() / "data", data);
  folder.commit();
}

/// Runs `work` in a process of its own and waits for its end.
template <class Work>
int in_process(Work work) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  return status;
}

std::string refusal(const fs::path& target, bool overwrite) {
  try {
    AtomicFolder folder(target, overwrite);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(AtomicFolder, AppearsWithTheCommit) {
  const TemporaryFolder place;
  {
    AtomicFolder folder(place / "deep/er/out/", false);
    write_file(folder.path() / "summary.json", kSummary);
    EXPECT_FALSE(fs::exists(place / "deep/er/out"));
    folder.commit();
    EXPECT_TRUE(is_result(place / "deep/er/out"));
  }
  EXPECT_EQ(names(place / "deep/er"), std::vector<std::string>{"out"});
}

TEST(AtomicFolder, NothingIsLeftWithoutACommit) {
  const TemporaryFolder place;
  { write_file(AtomicFolder(place / "out", false).path() / "data", "half"); }
  EXPECT_TRUE(names(place.path()).empty());
}

TEST(AtomicFolder, CheckpointsKeepWhatIsNotWrittenAgain) {
  const TemporaryFolder place;
  AtomicFolder folder(place / "out", false);
  write_file(folder.path() / "summary.json", kSummary);
  write_file(folder.path() / "first", "1");
  folder.commit();
  write_file(folder.path() / "second", "half");
  EXPECT_EQ(names(place / "out"), (std::vector<std::string>{".liesl", "first", "summary.json"}));
  write_file(folder.path() / "second", "2");
  folder.commit();
  EXPECT_EQ(names(place / "out"),
            (std::vector<std::string>{".liesl", "first", "second", "summary.json"}));
  EXPECT_EQ(read_file(place / "out/second"), "2");
}

TEST(AtomicFolder, KilledRunLeavesTheLastState) {
  const TemporaryFolder place;
  const int status = in_process([&] {
    AtomicFolder folder(place / "out", false);
    write_file(folder.path() / "summary.json", kSummary);
    write_file(folder.path() / "data", "complete");
    folder.commit();
    write_file(folder.path() / "data", "half");
    ::kill(::getpid(), SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(read_file(place / "out/data"), "complete");
  EXPECT_EQ(names(place.path()).size(), 2u);  // the unfinished folder of the dead process

  write_result(place / "out", "next", true);
  EXPECT_EQ(read_file(place / "out/data"), "next");
  EXPECT_EQ(names(place.path()), std::vector<std::string>{"out"});
}

TEST(AtomicFolder, KilledRunLeavesAnEarlierResult) {
  const TemporaryFolder place;
  write_result(place / "out", "earlier");
  in_process([&] {
    AtomicFolder folder(place / "out", true);
    write_file(folder.path() / "data", "half");
    ::kill(::getpid(), SIGKILL);
  });
  EXPECT_EQ(read_file(place / "out/data"), "earlier");
}

TEST(AtomicFolder, ReaderSeesOneStateOrTheOther) {
  const TemporaryFolder place;
  write_result(place / "out", "state 0");
  const pid_t writer = ::fork();
  if (writer == 0) {
    AtomicFolder folder(place / "out", true);
    for (int i = 1; i <= 200; ++i) {
      write_file(folder.path() / "summary.json", kSummary);
      write_file(folder.path() / "data", "state " + std::to_string(i));
      folder.commit();
    }
    ::_exit(0);
  }
  for (int status = 0; ::waitpid(writer, &status, WNOHANG) == 0;) {
    ASSERT_TRUE(fs::is_directory(place / "out"));
  }
  EXPECT_EQ(read_file(place / "out/data"), "state 200");
}

TEST(AtomicFolder, RecoversAResultThatWasMovedAside) {
  const TemporaryFolder place;
  write_result(place / ".out.previous", "earlier");
  { AtomicFolder folder(place / "out", true); }
  EXPECT_EQ(read_file(place / "out/data"), "earlier");
}

TEST(AtomicFolder, RefusesWhatIsNotOurs) {
  const TemporaryFolder place;
  fs::create_directory(place / "photos");
  write_file(place / "photos/a.jpg", "picture");
  EXPECT_NE(refusal(place / "photos", true).find("it holds 'a.jpg' and is not a result of liesl"),
            std::string::npos);
  write_file(place / "photos/summary.json", "{}");
  EXPECT_NE(refusal(place / "photos", true).find("not a result of liesl"), std::string::npos);
  EXPECT_EQ(read_file(place / "photos/a.jpg"), "picture");

  write_result(place / "out", "earlier");
  EXPECT_NE(refusal(place / "out", false).find("--force"), std::string::npos);
  EXPECT_EQ(refusal(place / "out", true), "");

  fs::create_directory(place / "empty");
  EXPECT_EQ(refusal(place / "empty", false), "");
}

TEST(AtomicFolder, NamesWhatCannotBeWritten) {
  const TemporaryFolder place;
  write_file(place / "file", "text");
  EXPECT_NE(refusal(place / "file", true).find("is a file"), std::string::npos);
  const std::string through = refusal(place / "file/out", false);  // also for root
  EXPECT_NE(through.find("file/out"), std::string::npos);
  EXPECT_NE(through.find("Not a directory"), std::string::npos) << through;
  EXPECT_NE(refusal("/proc/liesl-out", false), "");
}

TEST(WriteFile, FullDiskIsNamed) {
  try {
    write_file("/dev/full", "text");
    FAIL() << "a full disk went unnoticed";
  } catch (const IoError& error) {
    EXPECT_STREQ(
        error.what(),
        "cannot write '/dev/full': the disk is full (No space left on device); make room or "
        "choose another folder");
  }
}

TEST(IoError, FullDiskIsNamedWhicheverLibrarySaysIt) {
  const IoError hdf5("write", "results.h5",
                     "file write failed: errno = 28, error message = 'No space left on device'");
  EXPECT_EQ(hdf5.reason(),
            "the disk is full (No space left on device); make room or choose another folder");
  const IoError quota("write", "results.h5",
                      "write failed: errno = 122, error message = 'Disk quota exceeded', buf = 1");
  EXPECT_EQ(quota.reason(), "Disk quota exceeded");
  EXPECT_EQ(IoError("write", "file", "Permission denied").reason(), "Permission denied");
}

TEST(ReadFile, RefusesFoldersMissingAndHugeFiles) {
  const TemporaryFolder place;
  EXPECT_THROW(read_file(place.path()), IoError);
  EXPECT_THROW(read_file(place / "nothing"), IoError);
  write_file(place / "file", std::string(2000, 'x'));
  EXPECT_THROW(read_file(place / "file", 1000), IoError);
  EXPECT_EQ(read_file(place / "file").size(), 2000u);
}

// FIPS 180-2, appendix B.1; and the hash of nothing.
TEST(Sha256, KnownValues) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace liesl::test::atomic_folder_test
