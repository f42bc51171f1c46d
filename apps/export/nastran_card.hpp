#pragma once
/// @file
/// Cards of Nastran in large fields.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace liesl::nastran {

using Fields = std::vector<std::string>;

/// In 16 columns; |value| < 1e-98 is 0.
std::string number(double value);
Fields& operator<<(Fields& fields, const Eigen::Vector3d& v);
/// A name of 8 characters, lines of four fields of 16, an even number of them: each two hold
/// what one line of small fields does.
std::string card(const std::string& name, const Fields& fields);
/// A line for people, cut at the 72 columns of the case control.
std::string title(const std::string& text);

}  // namespace liesl::nastran
