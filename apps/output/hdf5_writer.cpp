#include "apps/output/hdf5_writer.hpp"

#include "apps/output/data_tree.hpp"
#include "apps/output/hdf5_file.hpp"

namespace liesl::output {

void write_hdf5(const std::filesystem::path& path, const Results& results) {
  const DataTree tree = data_tree(results);
  Hdf5File file(path);
  for (const DataGroup& group : tree.groups) {
    if (group.name != "/") file.group(group.name);
    for (const auto& [key, text] : group.attributes) file.attribute(group.name, key, text);
  }
  for (const DataSet& set : tree.sets) {
    const Hdf5File::Shape shape(set.shape.begin(), set.shape.end());
    if (const auto* numbers = std::get_if<std::span<const double>>(&set.values))
      file.write(set.name, *numbers, shape);
    else if (const auto* integers = std::get_if<std::vector<int>>(&set.values))
      file.write(set.name, *integers, shape);
    else
      file.write(set.name, std::get<std::vector<std::string>>(set.values));
    if (!set.unit.empty()) file.attribute(set.name, "unit", set.unit);
  }
  file.close();
}

}  // namespace liesl::output
