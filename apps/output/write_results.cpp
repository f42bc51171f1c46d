#include "apps/output/write_results.hpp"

#include "apps/output/csv_writer.hpp"
#include "apps/output/hdf5_writer.hpp"
#include "apps/output/picture_writer.hpp"
#include "apps/output/xdmf_writer.hpp"

namespace liesl::output {

void write_shown(const std::filesystem::path& folder, const Results& results) {
  check_shapes(results);
  write_hdf5(folder / "results.h5", results);
  write_xdmf(folder / "results.xdmf", "results.h5", results);
}

void write_results(const std::filesystem::path& folder, const Results& results) {
  write_shown(folder, results);
  if (!results.responses.empty()) write_responses_csv(folder / "responses.csv", results);
  if (!results.energies.total.empty()) write_energies_csv(folder / "energies.csv", results);
  if (!results.joints.empty()) write_joints_csv(folder / "joints.csv", results);
  write_frames_csv(folder / "frames.csv", results, kFrames);
  write_sections_csv(folder / "sections.csv", results);
  write_part_lines_csv(folder / "part_lines.csv", results);
}

}  // namespace liesl::output
