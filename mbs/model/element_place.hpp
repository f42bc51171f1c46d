#pragma once
/// @file
/// Where on a beam element its section forces are meant.

namespace liesl {

/// At a node they are those of the element's elastic end forces, moments linear in between; in the
/// middle K eps.
enum class ElementPlace { First, Middle, Last };

/// Node of the element, 0 or 1, in whose axes they are; the first node's in the middle.
inline int node_of(ElementPlace place) { return place == ElementPlace::Last; }

}  // namespace liesl
