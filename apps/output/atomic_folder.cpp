#include "apps/output/atomic_folder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

/// `.<name>.<what>` beside `target`.
fs::path sibling(const fs::path& target, const std::string& what) {
  return target.parent_path() / ("." + target.filename().string() + "." + what);
}

/// Refuses a target whose content is not ours to replace.
void check_replaceable(const fs::path& target, bool overwrite) {
  std::error_code error;
  const auto status = fs::status(target, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw IoError("write to", target, "is a file, not a folder");
  if (fs::is_empty(target, error) && !error) return;
  if (!is_result(target)) {
    throw IoError("write to", target,
                  "the folder is not empty and not a result of liesl; choose another");
  }
  if (!overwrite) {
    throw IoError("write to", target, "holds an earlier result; --force replaces it");
  }
}

/// Puts `from` at the place of the folder `to`; afterwards `from` holds the former one or is gone.
void exchange(const fs::path& from, const fs::path& to) {
  if (!fs::exists(to)) {
    fs::rename(from, to);
    return;
  }
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  // Not every file system can exchange; remove_leftovers() mends a kill between the next two lines.
  const fs::path aside = sibling(to, "previous");
  fs::rename(to, aside);
  fs::rename(from, to);
  fs::rename(aside, from);
}

}  // namespace

/// Clears up after killed runs: unfinished folders of processes that are gone, and a result that
/// was moved aside while the file system could not exchange two folders.
void remove_leftovers(const fs::path& target) {
  std::error_code error;
  const fs::path aside = sibling(target, "previous");
  if (fs::exists(aside, error) && !fs::exists(target, error)) fs::rename(aside, target, error);
  fs::remove_all(aside, error);

  const std::string prefix = sibling(target, "partial-").filename().string();
  for (const auto& entry : fs::directory_iterator(target.parent_path(), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const int pid = std::atoi(name.c_str() + prefix.size());
    if (pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), error);
  }
}

bool is_result(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "summary.json", error)) return false;
  try {
    const auto json = nlohmann::json::parse(read_file(folder / "summary.json"));
    return json.contains("/versions/liesl"_json_pointer);
  } catch (const std::exception&) {
    return false;
  }
}

AtomicFolder::AtomicFolder(const fs::path& target, bool overwrite) try {
  target_ = fs::absolute(target).lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();  // "demo/"
  if (fs::is_symlink(target_)) target_ = fs::canonical(target_);
  fs::create_directories(target_.parent_path());
  remove_leftovers(target_);
  check_replaceable(target_, overwrite);
  partial_ = sibling(target_, "partial-" + std::to_string(::getpid()));
  fs::remove_all(partial_);
  fs::create_directory(partial_);
  // Two empty folders may as well change places: shows now, not after the run, whether they can
  // (they cannot where the target is a mount point).
  if (fs::exists(target_) && fs::is_empty(target_)) exchange(partial_, target_);
} catch (const fs::filesystem_error& error) {
  throw IoError("write to", target, error.code().message());
}

AtomicFolder::~AtomicFolder() {
  std::error_code error;
  fs::remove_all(partial_, error);
}

const fs::path& AtomicFolder::path() {
  if (committed_) {
    try {
      fs::remove_all(partial_);
      fs::copy(target_, partial_, fs::copy_options::recursive);
    } catch (const fs::filesystem_error& error) {
      throw IoError("write to", partial_, error.code().message());
    }
    committed_ = false;
  }
  return partial_;
}

void AtomicFolder::commit() {
  if (committed_) return;
  try {
    exchange(partial_, target_);
    fs::remove_all(partial_);
  } catch (const fs::filesystem_error& error) {
    throw IoError("write to", target_, error.code().message());
  }
  committed_ = true;
}

}  // namespace liesl::output
