#pragma once
/// @file
/// The part of the HDF5 C API that the writer needs, with owners and exceptions.

#include <hdf5.h>

#include <filesystem>
#include <initializer_list>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace liesl::output {

/// To be called before any other function of the library, in every thread, of which each has its
/// own errors: they are thrown, not printed, and the library does nothing at the end of the
/// program, where it does not survive a file that a full disk kept it from closing.
inline void prepare_hdf5() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// To be called before a file is made or opened: the library (1.10, H5AC_create) does not survive
/// that there is no memory for the cache of the file. @throws std::bad_alloc
inline void require_room_for_file() {
  constexpr std::size_t kRoom = std::size_t{4} << 20;  // bytes, more than a file takes
  ::operator delete(::operator new(kRoom));
}

/// How values go to and from a file: those that are converted, texts and integers, through a small
/// buffer. The library clears a megabyte in each call otherwise.
hid_t transfer();

/// Owner of an HDF5 identifier. Closes it in the end.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close closer) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) closer_(id_);
  }
  hid_t id() const { return id_; }
  /// Closes now. @returns whether that worked
  bool close() { return closer_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  Close closer_;
};

/// A new HDF5 file with groups, data sets and text attributes. Every method throws IoError with the
/// library's reason.
class Hdf5File {
 public:
  using Shape = std::vector<hsize_t>;

  explicit Hdf5File(const std::filesystem::path& path);
  void group(const std::string& name) const;
  void write(const std::string& name, const std::vector<double>& values, const Shape& shape) const;
  void write(const std::string& name, std::span<const double> values, const Shape& shape) const;
  void write(const std::string& name, const std::vector<int>& values, const Shape& shape) const;
  /// A data set of numbers that write_rows fills.
  Hdf5Handle numbers(const std::string& name, const Shape& shape) const;
  /// Its rows from `first` on. @param shape of the values
  void write_rows(const Hdf5Handle& set, hsize_t first, std::span<const double> values,
                  const Shape& shape) const;
  /// Texts, UTF-8 of any length.
  void write(const std::string& name, const std::vector<std::string>& texts) const;
  /// Everything in another file, as a new group.
  void copy(const std::filesystem::path& from, const std::string& group) const;
  /// Text attribute of a group or data set.
  void attribute(const std::string& object, const std::string& key, const std::string& text) const;
  /// Flushes and closes: a full disk may show only here.
  void close();

 private:
  [[noreturn]] void fail() const;
  hid_t checked(hid_t id) const {
    if (id < 0) fail();
    return id;
  }
  Hdf5Handle create(const std::string& name, hid_t type, const Shape& shape) const;
  void write_any(const std::string& name, hid_t type, const void* data, const Shape& shape) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace liesl::output
