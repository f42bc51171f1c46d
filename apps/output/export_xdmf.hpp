#pragma once
/// @file
/// Deformed meshes for ParaView, from the amplitudes in results.h5.

#include <filesystem>

namespace liesl::output {

/// Writes meshes.h5, the deformed nodes of all meshed parts at the records that pictures show, and
/// results.xdmf, which describes both files. @throws IoError for a folder without results.h5, or of
/// a version that kept no amplitudes
void export_xdmf(const std::filesystem::path& folder);

}  // namespace liesl::output
