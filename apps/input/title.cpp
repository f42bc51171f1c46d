#include "apps/input/title.hpp"

#include <filesystem>

#include "apps/input/problem.hpp"

namespace liesl {

std::string title(const toml::table& root, const std::string& file) {
  std::error_code error;
  const toml::node* name = root.get("name");
  if ((name && written(*name)) || !std::filesystem::is_regular_file(file, error))
    return text(root, "name");
  return std::filesystem::path(file).stem().string();
}

}  // namespace liesl
