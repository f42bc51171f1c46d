#pragma once
/// @file
/// Cards of Nastran in large fields.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace liesl::nastran {

using Fields = std::vector<std::string>;

std::string number(double value);
Fields& operator<<(Fields& fields, const Eigen::Vector3d& v);
/// A name of 8 characters, lines of four fields of 16.
std::string card(const std::string& name, const Fields& fields);

}  // namespace liesl::nastran
