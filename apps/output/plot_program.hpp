#pragma once
/// @file
/// Calls the drawing program, apps/plot/plot.py.

#include <filesystem>
#include <string>
#include <vector>

namespace liesl::output {

/// Draws the results in `folder` (of a batch: one column of its table over another, if `x` and `y`
/// name some) into `folder/plots` and returns the pictures' paths. The script is
/// looked for at share/liesl/plot/plot.py beside the bin folder of this program, the interpreter is
/// $LIESL_PYTHON or the one found when the build was configured.
/// @throws IoError if there is nothing to draw, or the script ends with an error (its reason)
std::vector<std::filesystem::path> draw(const std::filesystem::path& folder,
                                        const std::string& x = "", const std::string& y = "");

}  // namespace liesl::output
