#include "apps/output/hdf5_input.hpp"

#include <algorithm>

#include "apps/output/io_error.hpp"

namespace liesl::output {
namespace {

hid_t open_file(const std::filesystem::path& path) {
  prepare_hdf5();
  require_room_for_file();
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

/// One behind the last of the records that are read at once, with those between them.
std::size_t end_of_block(const std::vector<int>& records, std::size_t first, std::size_t bytes) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 18;  // bytes
  constexpr int kNear = 4;                               // records apart
  std::size_t end = first + 1;
  while (end < records.size() && records[end] - records[end - 1] <= kNear &&
         static_cast<std::size_t>(records[end] - records[first] + 1) * bytes <= kAtOnce)
    ++end;
  return end;
}

std::vector<hsize_t> extent(hid_t set) {
  const Hdf5Handle space(H5Dget_space(set), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> size(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
  return size;
}

}  // namespace

std::size_t Hdf5Numbers::row() const {
  std::size_t count = 1;
  for (std::size_t i = 1; i < shape.size(); ++i) count *= shape[i];
  return count;
}

Hdf5Input::Hdf5Input(const std::filesystem::path& path)
    : path_(path), file_(open_file(path), H5Fclose) {
  if (file_.id() < 0) throw IoError("read", path_, "it is no HDF5 file, or not a whole one");
}

void Hdf5Input::fail(const std::string& name) const {
  throw IoError("read", path_, "'" + name + "' is not what liesl writes there");
}

bool Hdf5Input::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1))
    if (H5Lexists(file_.id(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Input::children(const std::string& group) const {
  std::vector<std::string> names;
  if (!has(group)) return names;
  const Hdf5Handle id(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose);
  if (id.id() < 0) fail(group);
  H5Literate(id.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names);
  return names;
}

std::string Hdf5Input::attribute(const std::string& object, const std::string& key) const {
  if (H5Aexists_by_name(file_.id(), object.c_str(), key.c_str(), H5P_DEFAULT) <= 0) return "";
  const Hdf5Handle id(
      H5Aopen_by_name(file_.id(), object.c_str(), key.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(id.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) fail(object);
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(id.id(), type.id(), text.data()) < 0) fail(object);
  return text.c_str();
}

Hdf5Handle Hdf5Input::open(const std::string& name) const {
  Hdf5Handle set(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (set.id() < 0) fail(name);
  return set;
}

Hdf5Kind Hdf5Input::kind(const std::string& name) const {
  const Hdf5Handle group(H5Gopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (group.id() >= 0) return Hdf5Kind::Group;
  const Hdf5Handle set = open(name);
  const Hdf5Handle type(H5Dget_type(set.id()), H5Tclose);
  const H5T_class_t of = H5Tget_class(type.id());
  return of == H5T_STRING    ? Hdf5Kind::Texts
         : of == H5T_INTEGER ? Hdf5Kind::Integers
                             : Hdf5Kind::Numbers;
}

std::vector<std::size_t> Hdf5Input::shape(const std::string& name) const {
  if (!has(name)) return {};
  const Hdf5Handle set = open(name);
  const auto size = extent(set.id());
  return {size.begin(), size.end()};
}

Hdf5Numbers Hdf5Input::numbers(const std::string& name) const {
  Hdf5Numbers out;
  if (!has(name)) return out;
  const Hdf5Handle set = open(name);
  const auto size = extent(set.id());
  out.shape.assign(size.begin(), size.end());
  out.values.resize(out.shape.empty() ? 0 : out.shape[0] * out.row());
  if (!out.values.empty() &&
      H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, transfer(), out.values.data()) < 0)
    fail(name);
  return out;
}

Hdf5Numbers Hdf5Input::numbers(const std::string& name, const std::vector<int>& records) const {
  Hdf5Numbers out;
  if (!has(name)) return out;
  const Hdf5Handle set = open(name);
  const auto size = extent(set.id());
  if (size.empty() || (!records.empty() && static_cast<hsize_t>(records.back()) >= size[0]))
    fail(name);
  if (records.size() == size[0]) return numbers(name);
  out.shape.assign(size.begin(), size.end());
  out.shape[0] = records.size();
  const std::size_t row = out.row();
  out.values.resize(records.size() * row);
  const Hdf5Handle space(H5Dget_space(set.id()), H5Sclose);
  std::vector<hsize_t> start(size.size(), 0), count = size;
  std::vector<double> block;
  for (std::size_t i = 0, end = 0; i < records.size(); i = end) {
    end = end_of_block(records, i, row * sizeof(double));
    start[0] = static_cast<hsize_t>(records[i]);
    count[0] = static_cast<hsize_t>(records[end - 1] - records[i] + 1);
    block.resize(count[0] * row);
    const Hdf5Handle here(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                          H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    if (H5Dread(set.id(), H5T_NATIVE_DOUBLE, here.id(), space.id(), transfer(), block.data()) < 0)
      fail(name);
    for (std::size_t k = i; k < end; ++k)
      std::copy_n(block.begin() + static_cast<long>(row) * (records[k] - records[i]), row,
                  out.values.begin() + static_cast<long>(k * row));
  }
  return out;
}

std::vector<std::string> Hdf5Input::texts(const std::string& name) const {
  std::vector<std::string> out;
  if (!has(name)) return out;
  const Hdf5Handle set = open(name);
  const Hdf5Handle type(H5Dget_type(set.id()), H5Tclose);
  const auto size = extent(set.id());
  if (H5Tis_variable_str(type.id()) <= 0 || size.size() != 1) fail(name);
  std::vector<char*> data(size[0], nullptr);
  const Hdf5Handle space(H5Dget_space(set.id()), H5Sclose);
  if (H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, transfer(), data.data()) < 0) fail(name);
  for (const char* text : data) out.emplace_back(text ? text : "");
  H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, data.data());
  return out;
}

}  // namespace liesl::output
