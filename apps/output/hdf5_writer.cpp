#include "apps/output/hdf5_writer.hpp"

#include <stdexcept>

#include "apps/output/data_tree.hpp"
#include "apps/output/memory_limit.hpp"

namespace liesl::output {
namespace {

Hdf5File::Shape shape_of(const DataSet& set) { return {set.shape.begin(), set.shape.end()}; }

void write_groups(const Hdf5File& file, const DataTree& tree) {
  for (const DataGroup& group : tree.groups) {
    if (group.name != "/") file.group(group.name);
    for (const auto& [key, text] : group.attributes) file.attribute(group.name, key, text);
  }
}

void write_unit(const Hdf5File& file, const DataSet& set) {
  if (!set.unit.empty()) file.attribute(set.name, "unit", set.unit);
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path) : path_(path) {
  if (memory_is_limited()) prepare_hdf5();  // which needs memory, while there is some
  made_ = std::async(beside(), [path] { return Hdf5File(path); });
}

void Hdf5Writer::discard() {
  if (finished_) return;
  made_ = {};  // once it is made
  prepare_hdf5();
  series_.clear();
  file_.reset();
  std::error_code none;
  std::filesystem::remove(path_, none);
}

Hdf5File& Hdf5Writer::file() {
  if (memory_is_limited()) require_room_for_file();
  if (!file_) file_.emplace(made_.get());
  prepare_hdf5();  // another thread may have made it
  return *file_;
}

void Hdf5Writer::put(const std::vector<BodyResult>& bodies, std::size_t first, std::size_t count,
                     std::size_t n) {
  for (const BodyResult& body : bodies) check_shapes(body, count);
  if (first != records_)
    throw std::invalid_argument("results: blocks of records do not follow each other");
  const DataTree tree = series_tree(bodies, count);
  const bool first_block = !file_;
  Hdf5File& file = this->file();
  if (first_block) {
    write_groups(file, tree);
    for (const DataSet& set : tree.sets) {
      Hdf5File::Shape shape = shape_of(set);
      shape[0] = n;
      series_.push_back(file.numbers(set.name, shape));
      write_unit(file, set);
    }
  }
  if (tree.sets.size() != series_.size())
    throw std::invalid_argument("results: the bodies have other series than in the first block");
  for (std::size_t i = 0; i < series_.size(); ++i)
    file.write_rows(series_[i], first, std::get<std::span<const double>>(tree.sets[i].values),
                    shape_of(tree.sets[i]));
  records_ += count;
}

void Hdf5Writer::finish(const Results& results) {
  if (records_ != (results.kept.empty() ? 0 : results.times.size()))
    throw std::invalid_argument("results: the file has series of bodies of other records");
  const DataTree tree = data_tree(results);
  Hdf5File& file = this->file();
  write_groups(file, tree);
  for (const DataSet& set : tree.sets) {
    if (const auto* numbers = std::get_if<std::span<const double>>(&set.values))
      file.write(set.name, *numbers, shape_of(set));
    else if (const auto* integers = std::get_if<std::vector<int>>(&set.values))
      file.write(set.name, *integers, shape_of(set));
    else
      file.write(set.name, std::get<std::vector<std::string>>(set.values));
    write_unit(file, set);
  }
  series_.clear();
  file.close();
  finished_ = true;
}

void write_hdf5(const std::filesystem::path& path, const Results& results) {
  check_shapes(results);  // before a file is overwritten
  Hdf5Writer(path).finish(results);
}

}  // namespace liesl::output
