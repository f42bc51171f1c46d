#pragma once
/// @file
/// The results of all cases of a batch in one table, one CSV file and one HDF5 file.

#include <map>

#include "apps/batch/batch.hpp"
#include "apps/output/csv_writer.hpp"

namespace liesl {

/// Rows are the cases that have ended, in the order of the batch.
struct BatchTable {
  output::TextColumn cases{"case", "", {}}, status{"status", "", {}}, reason{"reason", "", {}};
  std::vector<output::TextColumn> inputs;   ///< a column of the batch each
  std::vector<output::TextColumn> figures;  ///< of the summaries; empty where a case has none

  std::map<std::string, int> statuses;  ///< how many cases ended how
  int failed = 0;
  double cpu_s = 0;  ///< of all processes
  std::size_t rows() const { return cases.cells.size(); }
};

/// Reads the marks and summaries in the folder of a batch. @throws output::IoError
BatchTable collect_cases(const Batch& batch, const std::filesystem::path& folder);

/// results.csv: case, inputs, status, reason, figures. Replaces the file in one step.
void write_batch_csv(const std::filesystem::path& folder, const BatchTable& table);

/// results.h5: the table and the results.h5 of every case, layout in docs/outputs.md. Replaces the
/// file in one step.
void write_batch_hdf5(const std::filesystem::path& folder, const BatchTable& table);

}  // namespace liesl
