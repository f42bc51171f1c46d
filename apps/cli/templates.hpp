#pragma once
/// @file
/// Shipped scenes and studies as texts of the program.

#include <string_view>
#include <vector>

namespace liesl {

struct Template {
  std::string_view kind;    ///< "scene", "study"; "part": the scene of a study of fixed loads
  std::string_view folder;  ///< "scenes", "parts", "studies"
  std::string_view name;    ///< "four_bar"
  std::string_view text;
};

/// In the order of their folders and names.
const std::vector<Template>& templates();

}  // namespace liesl
