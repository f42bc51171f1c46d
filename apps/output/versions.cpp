#include "apps/output/versions.hpp"

#include "apps/output/version_table.hpp"

namespace liesl::output {

std::vector<std::pair<std::string, std::string>> versions() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const Version* v = kVersions; v->name; ++v)
    if (*v->version) found.emplace_back(v->name, v->version);
  return found;
}

}  // namespace liesl::output
