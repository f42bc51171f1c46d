#pragma once
/// @file
/// Entries and values of validated tables.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "apps/input/validate.hpp"

namespace liesl {

using Vec3 = Eigen::Vector3d;

/// Entries of a table in the order of the file.
struct Entry {
  std::string name;
  const toml::key* key;
  toml::table* table;
};
/// All entries of a table.
std::vector<Entry> entries_of(toml::table& table);
/// All entries of a top-level table, none if there is none.
std::vector<Entry> entries_at(toml::table& root, std::string_view group);
/// Those of them that are not broken.
std::vector<Entry> entries(toml::table& root, const Broken& broken, std::string_view group);

// Values of validated tables; zero or empty if missing.
std::string text(const toml::table& table, std::string_view key);
double number(const toml::table& table, std::string_view key);
int integer(const toml::table& table, std::string_view key);
bool boolean(const toml::table& table, std::string_view key);
Vec3 vec3(const toml::node& list);
Vec3 vec3(const toml::table& table, std::string_view key);
std::vector<double> numbers(const toml::node& list);
/// Nodes of a string or a list of strings.
std::vector<const toml::node*> strings(const toml::table& table, std::string_view key);
/// n x n from rows or a diagonal (n = 3 also [xx, yy, zz, xy, xz, yz]).
Eigen::MatrixXd matrix(const toml::node& list, int n);

}  // namespace liesl
