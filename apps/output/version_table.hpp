#pragma once
/// @file
/// What this program was built from, for programs that use the C library alone.

namespace liesl::output {

struct Version {
  const char *name, *version;  ///< no version: built without it
};

/// liesl first, then the compiler and every library, as found when the build was configured; the
/// last one has no name.
extern const Version kVersions[];

}  // namespace liesl::output
