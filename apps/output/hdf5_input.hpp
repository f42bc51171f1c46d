#pragma once
/// @file
/// An HDF5 file that is read: groups, data sets of numbers or texts, text attributes.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/output/hdf5_file.hpp"

namespace liesl::output {

/// Numbers of a data set, by rows; an empty shape if the file has none of that name.
struct Hdf5Numbers {
  std::vector<std::size_t> shape;
  std::vector<double> values;

  bool empty() const { return values.empty(); }
  /// Product of all sizes but the first: numbers of one record.
  std::size_t row() const;
};

enum class Hdf5Kind { Group, Numbers, Integers, Texts };

/// Every method throws IoError for a file that cannot be read.
class Hdf5Input {
 public:
  explicit Hdf5Input(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  bool has(const std::string& name) const;
  Hdf5Kind kind(const std::string& name) const;
  /// Names in a group, in the order of the alphabet; none if there is no such group.
  std::vector<std::string> children(const std::string& group) const;
  /// Text attribute of an object; empty if there is none.
  std::string attribute(const std::string& object, const std::string& key) const;
  /// Sizes of a data set; empty if there is none.
  std::vector<std::size_t> shape(const std::string& name) const;
  Hdf5Numbers numbers(const std::string& name) const;
  /// Only these records, numbers of the first index.
  Hdf5Numbers numbers(const std::string& name, const std::vector<int>& records) const;
  /// A list of texts; empty if there is none.
  std::vector<std::string> texts(const std::string& name) const;

 private:
  [[noreturn]] void fail(const std::string& name) const;
  Hdf5Handle open(const std::string& name) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace liesl::output
