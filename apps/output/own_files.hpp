#pragma once
/// @file
/// Which files of a results folder liesl wrote. It removes no others.

#include <filesystem>
#include <string>
#include <vector>

namespace liesl::output {

/// The mark of a results folder: a text file with a line for each file that liesl wrote in it.
inline constexpr const char* kMark = ".liesl";
/// The subfolder of pictures.
inline constexpr const char* kPictures = "plots";

/// True if the folder holds a result of liesl: it has its mark or, if it is older than marks, a
/// summary.json that names the version of liesl.
bool is_result(const std::filesystem::path& folder);

/// Adds files (paths relative to the folder, also such that are to be written) to its mark.
/// @throws IoError
void mark_files(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// Marks all that the folder holds, and nothing else. @throws IoError
void mark_all(const std::filesystem::path& folder);

/// What liesl did not write: files and empty folders, relative and sorted. In a result without mark
/// files of the names in docs/outputs.md are liesl's. Cases of a batch are results of their own.
std::vector<std::string> foreign_files(const std::filesystem::path& folder);

/// Files of its mark, in the folder itself, that are not there; without a mark the mark.
std::vector<std::string> missing_files(const std::filesystem::path& folder);

/// What a folder that is no result holds: "'a.txt' (and 2 more)", its first entry by name.
std::string content_of(const std::filesystem::path& folder);

/// @throws IoError that names the first of `foreign_files`, if there are any
void check_own(const std::filesystem::path& folder);

/// Removes what liesl wrote in the folder, all `but` one file, and the subfolders that are empty
/// then.
void remove_own(const std::filesystem::path& folder, const std::string& but = "");

/// Copies what liesl wrote in the folder into another one, which exists.
void copy_own(const std::filesystem::path& from, const std::filesystem::path& to);

/// Moves what liesl did not write into another folder; a name that is taken there gets a '~'.
void move_foreign(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace liesl::output
