#pragma once
/// @file
/// A results folder that is complete at every moment.

#include <filesystem>
#include <string>
#include <string_view>

namespace liesl::output {

/// Files are written into a hidden sibling folder `.<name>.partial-<pid>@<host>`, and `commit()`
/// puts that into the place of `target` in one step. A run that is interrupted, killed, or out of
/// disk space leaves at `target` what the last commit put there, or what was there before. (A loss
/// of power is not covered: nothing is forced to the disk.) `target` gets the mark of
/// own_files.hpp; what others put into it while the run goes on stays there.
///
/// @code
///   AtomicFolder folder("build/demo", /*overwrite=*/true);
///   for (...) {
///     write_file(folder.path() / "summary.json", ...);
///     folder.commit();  // a checkpoint
///   }
/// @endcode
class AtomicFolder {
 public:
  /// Creates the sibling folder (and parents), removes those that killed runs have left behind.
  /// An existing `target` must be empty or, with `overwrite`, an earlier result of liesl and
  /// nothing else. No other process may be writing to it.
  /// @throws IoError
  AtomicFolder(const std::filesystem::path& target, bool overwrite);
  /// Removes the sibling folder; `target` stays as committed.
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Where to write. After a commit it holds a copy of what was committed, so that a checkpoint
  /// writes only what is new. @throws IoError
  const std::filesystem::path& path();

  /// Makes the files written so far the content of `target`. @throws IoError
  void commit();

  const std::filesystem::path& target() const { return target_; }

 private:
  std::filesystem::path target_, partial_;
  bool committed_ = false;  ///< and not written to since
};

/// Removes what killed runs of this computer have left beside `target`. The constructor of
/// AtomicFolder does, too.
void remove_leftovers(const std::filesystem::path& target);

}  // namespace liesl::output
