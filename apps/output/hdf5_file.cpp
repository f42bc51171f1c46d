#include "apps/output/hdf5_file.hpp"

#include <new>
#include <string>

#include "apps/output/io_error.hpp"

namespace liesl::output {
namespace {

/// Innermost entry of the library's error stack: there the system's reason stands.
struct Innermost {
  std::string text = "HDF5 gives no reason";
  bool memory = false;  ///< it was refused memory: that comes without a reason of the system
};

herr_t keep_innermost(unsigned, const H5E_error2_t* error, void* kept) {
  Innermost& innermost = *static_cast<Innermost*>(kept);
  if (error->desc) innermost.text = error->desc;
  innermost.memory = error->maj_num == H5E_RESOURCE &&
                     (error->min_num == H5E_NOSPACE || error->min_num == H5E_CANTALLOC);
  return 0;
}

Hdf5Handle space_of(const Hdf5File::Shape& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose};
}

/// Numbers go to the file as they are. Never closed: that would take the reason of a file that
/// cannot be created from the library's error stack.
hid_t unbuffered() {
  static const hid_t access = [] {
    const hid_t made = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_sieve_buf_size(made, 0);
    return made;
  }();
  return access;
}

hid_t create_file(const std::filesystem::path& path) {
  prepare_hdf5();
  require_room_for_file();
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, unbuffered());
}

}  // namespace

hid_t transfer() {
  static const hid_t through = [] {
    constexpr std::size_t kBuffer = std::size_t{1} << 14;  // bytes
    const hid_t made = H5Pcreate(H5P_DATASET_XFER);
    return H5Pset_buffer(made, kBuffer, nullptr, nullptr) < 0 ? H5P_DEFAULT : made;
  }();
  return through;
}

Hdf5File::Hdf5File(const std::filesystem::path& path)
    : path_(path), file_(create_file(path), H5Fclose) {
  checked(file_.id());
}

void Hdf5File::fail() const {
  Innermost reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_innermost, &reason);
  H5Eclear2(H5E_DEFAULT);  // of this thread, which may end
  if (reason.memory) throw std::bad_alloc();
  throw IoError("write", path_, reason.text);
}

void Hdf5File::group(const std::string& name) const {
  const Hdf5Handle group(
      H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  checked(group.id());
}

void Hdf5File::write(const std::string& name, const std::vector<double>& values,
                     const Shape& shape) const {
  write_any(name, H5T_NATIVE_DOUBLE, values.data(), shape);
}

void Hdf5File::write(const std::string& name, std::span<const double> values,
                     const Shape& shape) const {
  write_any(name, H5T_NATIVE_DOUBLE, values.data(), shape);
}

void Hdf5File::write(const std::string& name, const std::vector<int>& values,
                     const Shape& shape) const {
  write_any(name, H5T_NATIVE_INT, values.data(), shape);
}

Hdf5Handle Hdf5File::create(const std::string& name, hid_t type, const Shape& shape) const {
  const Hdf5Handle space = space_of(shape);
  Hdf5Handle set(H5Dcreate2(file_.id(), name.c_str(), type, checked(space.id()), H5P_DEFAULT,
                            H5P_DEFAULT, H5P_DEFAULT),
                 H5Dclose);
  checked(set.id());
  return set;
}

Hdf5Handle Hdf5File::numbers(const std::string& name, const Shape& shape) const {
  return create(name, H5T_NATIVE_DOUBLE, shape);
}

void Hdf5File::write_rows(const Hdf5Handle& set, hsize_t first, std::span<const double> values,
                          const Shape& shape) const {
  const Hdf5Handle here = space_of(shape), there(H5Dget_space(set.id()), H5Sclose);
  Shape start(shape.size(), 0);
  start[0] = first;
  if (H5Sselect_hyperslab(checked(there.id()), H5S_SELECT_SET, start.data(), nullptr, shape.data(),
                          nullptr) < 0 ||
      H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, checked(here.id()), there.id(), H5P_DEFAULT,
               values.data()) < 0)
    fail();
}

void Hdf5File::write_any(const std::string& name, hid_t type, const void* data,
                         const Shape& shape) const {
  const Hdf5Handle set = create(name, type, shape);
  if (H5Dwrite(set.id(), type, H5S_ALL, H5S_ALL, transfer(), data) < 0) fail();
}

void Hdf5File::write(const std::string& name, const std::vector<std::string>& texts) const {
  std::vector<const char*> data;
  for (const std::string& text : texts) data.push_back(text.c_str());
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  write_any(name, type.id(), data.data(), {data.size()});
}

void Hdf5File::copy(const std::filesystem::path& from, const std::string& group) const {
  require_room_for_file();
  const Hdf5Handle source(H5Fopen(from.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (H5Ocopy(checked(source.id()), "/", file_.id(), group.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0)
    fail();
}

void Hdf5File::attribute(const std::string& object, const std::string& key,
                         const std::string& text) const {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), text.size() + 1);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate_by_name(file_.id(), object.c_str(), key.c_str(), type.id(),
                                               space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  checked(attribute.id());
  if (H5Awrite(attribute.id(), type.id(), text.c_str()) < 0) fail();
}

void Hdf5File::close() {
  if (H5Fflush(file_.id(), H5F_SCOPE_LOCAL) < 0 || !file_.close()) fail();
}

}  // namespace liesl::output
