#pragma once
/// @file
/// report.html: what a results folder holds, as one page for a browser.

#include <filesystem>
#include <string>

namespace liesl::report {

/// File of a results folder.
inline constexpr const char* kReport = "report.html";

/// The page of a results folder: one HTML text without requests to anything else. That of a case,
/// which is to stand in its folder, leads back to that of its batch.
/// @param name what the folder is called on the page
/// @throws output::IoError for a folder that is no result, or whose files are not what liesl
/// writes
std::string page_of(const std::filesystem::path& folder, const std::string& name);
/// The same of a folder that is finished, one with its mark and all numbers in it, to be put
/// anywhere.
std::string page_of_whole(const std::filesystem::path& folder, const std::string& name);

/// Writes report.html into a results folder and marks it as liesl's. @returns its path
/// @throws output::IoError, also if a report.html is there that liesl did not write
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace liesl::report
