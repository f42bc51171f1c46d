/// @file
/// Where the program that runs is installed: PREFIX/bin/liesl, which starts
/// PREFIX/libexec/liesl-program, and PREFIX/share/liesl. The build tree is laid out alike.
#pragma once

#include <filesystem>

namespace liesl::output {

/// The program as it is called: PREFIX/bin/liesl.
std::filesystem::path program_path();

/// Files that the program reads: PREFIX/share/liesl.
std::filesystem::path share_path();

}  // namespace liesl::output
