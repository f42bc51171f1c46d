#pragma once
/// @file
/// The message of an IoError, to be printed.

#include "apps/input/printable.hpp"
#include "apps/output/io_error.hpp"

namespace liesl {

/// Whole and printable: what() ends at the first NUL of a reason, as from a cell of a spoilt table.
inline std::string message(const output::IoError& error) {
  const std::size_t cut = error.reason().find('\0');
  return printable(error.what() + (cut == std::string::npos ? "" : error.reason().substr(cut)));
}

}  // namespace liesl
