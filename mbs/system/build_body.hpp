#pragma once
/// @file
/// The body of a model from its part of a mechanism. The kinds of bodies are known here and in
/// their own files (mbs/bodies); a new kind is a class derived from `Body` and an overload of
/// `make` in build_body.cpp.

#include <memory>
#include <vector>

#include "mbs/bodies/body.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

/// @param held nodes that joints, forces and loads hold on to, ascending: interfaces of a body
///   that is reduced to modes
/// @throws std::invalid_argument if the body cannot live in the space (a planar mesh in 3-D)
template <FrameGroup G>
std::unique_ptr<Body<G>> build_body(const BodySpec& spec, const Space<G>& space,
                                    Formalism formalism, const std::vector<int>& held);

extern template std::unique_ptr<Body<SE2>> build_body(const BodySpec&, const Space<SE2>&, Formalism,
                                                      const std::vector<int>&);
extern template std::unique_ptr<Body<SE3>> build_body(const BodySpec&, const Space<SE3>&, Formalism,
                                                      const std::vector<int>&);

}  // namespace liesl
