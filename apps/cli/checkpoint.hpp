#pragma once
/// @file
/// The cycles of an optimisation as a file, from which an interrupted run resumes.

#include <filesystem>
#include <string>
#include <vector>

#include "optim/cycle/motion_cycle.hpp"

namespace liesl {

/// @throws output::IoError
void write_checkpoint(const std::filesystem::path& path, const std::vector<Cycle>& history,
                      const std::string& input_sha256);

/// @throws output::IoError if the file cannot be read, InputError if it belongs to another input
std::vector<Cycle> read_checkpoint(const std::filesystem::path& path,
                                   const std::string& input_sha256);

}  // namespace liesl
