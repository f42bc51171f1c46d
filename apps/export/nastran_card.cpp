#include "apps/export/nastran_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace liesl::nastran {

std::string number(double value) {
  constexpr double kLeast = 1e-98;  // below, an exponent of three digits would not fit its field
  return fmt::format("{:.9E}", std::abs(value) < kLeast ? 0.0 : value);
}

Fields& operator<<(Fields& fields, const Eigen::Vector3d& v) {
  for (const double x : v) fields.push_back(number(x));
  return fields;
}

std::string card(const std::string& name, const Fields& fields) {
  constexpr std::size_t kFields = 4;  // of a line
  std::size_t lines = (fields.size() + kFields - 1) / kFields;
  lines += lines % 2;
  std::string text;
  for (std::size_t line = 0; line < lines; ++line) {
    text += fmt::format("{:<8}", line == 0 ? name + "*" : "*");
    for (std::size_t i = kFields * line; i < std::min(fields.size(), kFields * (line + 1)); ++i)
      text += fmt::format("{:>16}", fields[i]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

std::string title(const std::string& text) {
  constexpr std::size_t kColumns = 72;
  std::string line = text.substr(0, kColumns);
  const auto foreign = [](char c) { return static_cast<unsigned char>(c) > 127; };
  std::replace_if(line.begin(), line.end(), foreign, '?');  // also half a letter of UTF-8
  return line + "\n";
}

}  // namespace liesl::nastran
