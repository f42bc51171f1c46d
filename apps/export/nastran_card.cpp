#include "apps/export/nastran_card.hpp"

#include <fmt/format.h>

namespace liesl::nastran {

std::string number(double value) { return fmt::format("{:.9E}", value); }

Fields& operator<<(Fields& fields, const Eigen::Vector3d& v) {
  for (const double x : v) fields.push_back(number(x));
  return fields;
}

std::string card(const std::string& name, const Fields& fields) {
  std::string text = fmt::format("{:<8}", name + "*");
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0 && i % 4 == 0) text += "\n*       ";
    text += fmt::format("{:>16}", fields[i]);
  }
  return text + "\n";
}

}  // namespace liesl::nastran
