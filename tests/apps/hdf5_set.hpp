#pragma once
/// @file
/// Data sets of an HDF5 file, read with the library itself.

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <vector>

namespace liesl::test {

struct DataSet {
  std::vector<hsize_t> shape;
  std::vector<double> values;
};

/// A whole data set; empty shape if there is none of that name.
inline DataSet read_set(const std::filesystem::path& path, const std::string& name) {
  DataSet set;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t id = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  if (id >= 0) {
    const hid_t space = H5Dget_space(id);
    set.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, set.shape.data(), nullptr);
    set.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, set.values.data());
    H5Sclose(space);
    H5Dclose(id);
  }
  H5Fclose(file);
  return set;
}

}  // namespace liesl::test
