#pragma once
/// @file
/// Memory of long records. What a processor's memory holds is in large pages, where the system has
/// them on request: the first touch of a small page takes longer than the step of a planar beam
/// that fills half of it. What is more is in a file without a name in the folder for temporary
/// files, whose pages are let go once they are written or read.

#include <cstddef>

namespace liesl {

/// Room for doubles that moves as it grows. Room that was not written takes no memory.
class RecordMemory {
 public:
  static constexpr std::size_t kInMemory = std::size_t{16} << 20;  ///< bytes; more is in a file

  RecordMemory() = default;
  RecordMemory(RecordMemory&& other) noexcept;
  RecordMemory& operator=(RecordMemory&& other) noexcept;
  RecordMemory(const RecordMemory&) = delete;
  RecordMemory& operator=(const RecordMemory&) = delete;
  ~RecordMemory();

  double* data() { return data_; }
  const double* data() const { return data_; }
  std::size_t capacity() const { return capacity_; }  ///< doubles
  /// Where its pages are: false also if there is no room for a file, or files are in memory.
  bool in_file() const { return in_file_; }

  /// Room for so many doubles, aligned for every vector of the processor, the first `kept` of which
  /// are those that were there.
  /// @throws std::bad_alloc
  void reserve(std::size_t doubles, std::size_t kept);
  /// The file's pages between two doubles need not stay in memory; what they hold stays.
  void let_go(std::size_t first, std::size_t last) const;

 private:
  void release() noexcept;

  double* data_ = nullptr;
  std::size_t capacity_ = 0;
  bool in_file_ = false;
};

}  // namespace liesl
