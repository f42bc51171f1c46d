#pragma once
/// @file
/// Nodes and elements that a scene names by numbers of another mesh than that of the beam
/// (`beam.numbering`).

#include <optional>
#include <string>

#include "apps/input/values.hpp"
#include "mbs/model/element_place.hpp"

namespace liesl {

/// Of a mesh of equal elements, node k of `counted` elements is node k elements/counted.
class Numbering {
 public:
  /// @param root a validated scene. A body that is no beam, or has no numbering, counts as it is.
  Numbering(const toml::table& root, const std::string& body);

  /// "node3" as "node6", other names as they are. On no node of this mesh: a name of none.
  std::string port(const std::string& name) const;
  /// The same of what a support begins with, "node3:xyz".
  std::string support(const std::string& text) const;
  /// Elements that names count, where the beam has n.
  int elements(int n) const { return elements_ == counted_ ? n : counted_; }
  /// The element with the same end, or the same middle; none: this mesh has none.
  std::optional<int> element(int number, ElementPlace place) const;

 private:
  int elements_ = 1, counted_ = 1;
};

}  // namespace liesl
