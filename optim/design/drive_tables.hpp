#pragma once
/// @file
/// Tables of drives whose values, or whose duration, are variables.

#include "optim/study/study.hpp"

namespace liesl {

/// The tables of the study with these values of its constants; times stretched by the duration.
/// @param x by constant
std::vector<DriveTable> drive_tables(const std::vector<ConstantSpec>& constants,
                                     std::vector<DriveTable> tables, double duration,
                                     const std::vector<double>& x);

/// The duration that the constants have; none of them: that of the scene.
double duration_of(const std::vector<ConstantSpec>& constants, double duration,
                   const std::vector<double>& x);

}  // namespace liesl
