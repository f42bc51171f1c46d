#pragma once
/// @file
/// One value of a TOML file against its key of the schema; private to the folder.

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "apps/input/problem.hpp"
#include "apps/input/schema.hpp"

namespace liesl {

/// Type, range, options and number of entries of a value that is no table. Of a function of time
/// only the constant.
void check_value(const Key& key, toml::node& value, const std::string& path, Problems& problems);

/// "'path' is a string; expected a number".
void wrong_type(const Key& key, const toml::node& value, const std::string& path,
                Problems& problems);

/// Names become names of data sets and attributes in results.h5.
template <class Place>
void check_name_length(const Place& at, std::string_view text, const std::string& path,
                       Problems& problems) {
  constexpr std::size_t kLongest = 255;  // HDF5 takes more, file systems do not
  if (text.size() > kLongest)
    problems.add(at, fmt::format("'{}' is a name of {} characters", path, text.size()),
                 fmt::format("at most {} characters", kLongest));
}

}  // namespace liesl
