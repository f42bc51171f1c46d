#pragma once
/// @file
/// What a scene, study, batch or comparison is called.

#include <string>

#include "apps/input/values.hpp"

namespace liesl {

/// `name`; where that is not written the name of the file without its ending. Texts of no file (a
/// dict of Python) keep the default of the key.
std::string title(const toml::table& root, const std::string& file);

}  // namespace liesl
