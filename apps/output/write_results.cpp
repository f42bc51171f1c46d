#include "apps/output/write_results.hpp"

#include <future>

#include "apps/output/csv_writer.hpp"
#include "apps/output/picture_writer.hpp"
#include "apps/output/xdmf_writer.hpp"

namespace liesl::output {
namespace {

void finish_shown(const std::filesystem::path& folder, const Results& results, Hdf5Writer& file) {
  file.finish(results);
  write_xdmf(folder / "results.xdmf", "results.h5", results);
}

void write_tables(const std::filesystem::path& folder, const Results& results) {
  if (!results.responses.empty()) write_responses_csv(folder / "responses.csv", results);
  if (!results.energies.total.empty()) write_energies_csv(folder / "energies.csv", results);
  if (!results.joints.empty()) write_joints_csv(folder / "joints.csv", results);
  write_frames_csv(folder / "frames.csv", results, kFrames);
  write_rigid_paths_csv(folder / "rigid_paths.csv", results);
  write_sections_csv(folder / "sections.csv", results);
  write_part_lines_csv(folder / "part_lines.csv", results);
}

}  // namespace

void write_shown(const std::filesystem::path& folder, const Results& results) {
  check_shapes(results);
  Hdf5Writer file(folder / "results.h5");
  finish_shown(folder, results, file);
}

void write_results(const std::filesystem::path& folder, const Results& results, Hdf5Writer* begun) {
  check_shapes(results);
  auto tables = std::async([&] { write_tables(folder, results); });
  if (begun)
    finish_shown(folder, results, *begun);
  else
    write_shown(folder, results);
  tables.get();
}

}  // namespace liesl::output
