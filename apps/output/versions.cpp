#include "apps/output/versions.hpp"

namespace liesl::output {

std::vector<std::pair<std::string, std::string>> versions() {
  std::vector<std::pair<std::string, std::string>> found = {
#include "versions.inc"
  };
  std::erase_if(found, [](const auto& entry) { return entry.second.empty(); });
  return found;
}

}  // namespace liesl::output
