#include "apps/output/installation.hpp"

namespace liesl::output {

namespace fs = std::filesystem;

namespace {

/// The file of this process without the folders of LIESL_LIBEXECDIR and its name.
fs::path prefix() {
  fs::path path = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : fs::path(LIESL_LIBEXECDIR)) {
    (void)folder;
    path = path.parent_path();
  }
  return path;
}

}  // namespace

fs::path program_path() { return prefix() / LIESL_BINDIR / "liesl"; }

fs::path share_path() { return prefix() / "share/liesl"; }

}  // namespace liesl::output
