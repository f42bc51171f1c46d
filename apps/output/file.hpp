#pragma once
/// @file
/// Whole files in and out, and their hash.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace liesl::output {

/// Writes (replaces) a whole file. @throws IoError with the system's reason: disk full, no such
/// folder, permission denied, ... The file may then be incomplete: write into an AtomicFolder.
void write_file(const std::filesystem::path& path, std::string_view content);

/// The same, so that other processes see the former file or the whole new one.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// The process that replaces a file through one of this name; 0: replace_file() makes no such name.
int writer_of_part(const std::string& name);

/// Removes what killed processes of this computer left of files that they were replacing in
/// `folder`.
void remove_parts(const std::filesystem::path& folder);

/// Content of a whole regular file of at most `limit` bytes. @throws IoError
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 30);

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace liesl::output
