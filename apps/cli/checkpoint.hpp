#pragma once
/// @file
/// The cycles of an optimisation, by models and rounds with new holes, as a file, from which an
/// interrupted run resumes.

#include <filesystem>
#include <string>

#include "apps/tasks/optimize_verified.hpp"

namespace liesl {

/// @param input_sha256 of what a resumed run has to share, `Study::resumable`
/// @throws output::IoError
void write_checkpoint(const std::filesystem::path& path, const ModelHistory& models,
                      const std::string& input_sha256);

/// @throws output::IoError if the file cannot be read, InputError if it belongs to another input
ModelHistory read_checkpoint(const std::filesystem::path& path, const std::string& input_sha256);

}  // namespace liesl
