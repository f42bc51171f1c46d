#pragma once
/// @file
/// The motion in results.h5 as a page shows it.

#include <optional>

#include "apps/output/hdf5_input.hpp"
#include "apps/report/blob.hpp"

namespace liesl::report {

/// Bytes of the arrays of a motion, which decide how many instants are shown.
inline constexpr double kLeastMotionBytes = 100e3, kMostMotionBytes = 200e3;
inline constexpr int kFewestInstants = 60, kMostInstants = 600;

/// When a page begins: at the peak of the worst limit, of the first scenario, whose motion it
/// shows. Empty if there is none after the start: at the largest deformation then.
std::optional<double> opening(const Json& summary);

/// Bodies, meshed parts and joints at evenly spread records and the one nearest to `opening`:
/// {"abscissa", "unit", "records", "opens", "t", "bodies", "meshes", "joints"}; "opens" is where
/// that one is in "t". Null if the file has no records.
/// @param bytes that there is room for  @throws output::IoError
Json motion(const output::Hdf5Input& results, std::optional<double> opening, double bytes,
            Blob& blob);

}  // namespace liesl::report
