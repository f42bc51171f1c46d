#pragma once
/// @file
/// Results as one HDF5 file.

#include <cstddef>
#include <filesystem>
#include <future>
#include <optional>
#include <utility>
#include <vector>

#include "apps/output/hdf5_file.hpp"
#include "apps/output/results.hpp"

namespace liesl::output {

/// Everything that is recorded, as data_tree.hpp lays it out. Every data set of numbers has an
/// attribute `unit`. The file is made while its numbers are still computed, and taken away if they
/// do not come.
class Hdf5Writer final : public BodySink {
 public:
  explicit Hdf5Writer(const std::filesystem::path& path);
  ~Hdf5Writer() override { discard(); }
  /// Series of bodies before the rest, blocks in their order.
  /// @throws IoError, std::invalid_argument (shapes, another order)
  void put(const std::vector<BodyResult>& bodies, std::size_t first, std::size_t count,
           std::size_t n) override;
  /// All that was not put before, and closes the file.
  /// @throws IoError, std::invalid_argument (shapes, records that were not put)
  void finish(const Results& results);
  /// No file, as there are no numbers; nothing once it is finished.
  void discard();

 private:
  Hdf5File& file();

  std::filesystem::path path_;
  std::future<Hdf5File> made_;
  std::optional<Hdf5File> file_;  ///< once it is used
  bool finished_ = false;
  std::vector<Hdf5Handle> series_;  ///< in the order of series_tree()
  std::size_t records_ = 0;         ///< that were put
};

/// Writes results that hold all of their series.
/// @throws IoError, std::invalid_argument (shapes, results that keep few records)
void write_hdf5(const std::filesystem::path& path, const Results& results);

}  // namespace liesl::output
