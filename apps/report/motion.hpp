#pragma once
/// @file
/// The motion in results.h5 as a page shows it.

#include <filesystem>

#include "apps/report/blob.hpp"

namespace liesl::report {

/// Bytes of the arrays of a motion, which decide how many instants are shown.
inline constexpr double kMotionBytes = 200e3;
inline constexpr int kFewestInstants = 120, kMostInstants = 600;

/// Bodies, meshed parts and joints at evenly spread records:
/// {"abscissa", "unit", "records", "t", "bodies", "meshes", "joints"}. Null if the file has no
/// records. @throws output::IoError
Json motion(const std::filesystem::path& results, Blob& blob);

}  // namespace liesl::report
