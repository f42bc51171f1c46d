#include "apps/scene/numbering.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace liesl {
namespace {

/// Of "node3": 3.
std::optional<int> number_of(std::string_view name) {
  constexpr std::string_view kNode = "node";
  if (!name.starts_with(kNode)) return {};
  int number = 0;
  const char *first = name.data() + kNode.size(), *last = name.data() + name.size();
  const auto [end, error] = std::from_chars(first, last, number);
  return error == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace

Numbering::Numbering(const toml::table& root, const std::string& body) {
  const auto beam = root["bodies"][body]["beam"];
  const toml::table* table = beam.as_table();
  if (!table || !table->contains("numbering") || !table->contains("elements")) return;
  elements_ = integer(*table, "elements");
  counted_ = integer(*table, "numbering");
}

std::string Numbering::port(const std::string& name) const {
  const std::optional<int> number = number_of(name);
  if (!number || elements_ == counted_) return name;
  const long here = static_cast<long>(*number) * elements_;
  if (here % counted_ == 0) return fmt::format("node{}", here / counted_);
  return fmt::format("node{}*{}/{}", *number, elements_, counted_);
}

std::string Numbering::support(const std::string& text) const {
  const std::string place = text.substr(0, text.find(':'));
  return port(place) + text.substr(place.size());
}

std::optional<int> Numbering::element(int number, ElementPlace place) const {
  const long n = elements_, k = number;
  if (place == ElementPlace::Middle) {
    const long middle = (2 * k + 1) * n;  // in halves of the elements here, times counted_
    if (middle % counted_ != 0 || middle / counted_ % 2 == 0) return {};
    return static_cast<int>(middle / counted_ / 2);
  }
  const bool last = place == ElementPlace::Last;
  const long end = (last ? k + 1 : k) * n;
  if (end % counted_ != 0) return {};
  return static_cast<int>(end / counted_ - (last ? 1 : 0));
}

}  // namespace liesl
