#pragma once
/// @file
/// What a Lie group is to liesl. Symbols: liegroup/README.md. One property suite,
/// tests/liegroup/group_properties.hpp, runs for every group.

#include <Eigen/Core>
#include <concepts>

namespace liesl {

/// Fixed-size value type with a group operation and the maps between group and algebra.
/// All of h, a, v below are `Tangent` (dim x 1), local frame, translation first.
///
///   H1 * H2, H.inverse(), G::identity()
///   G::exp(h), G::log(H)          log(exp(h)) = h for a rotation below pi
///   H.Ad()                        Ad(H)  [dim x dim],  Ad(exp h) = expm(ad h)
///   G::ad(h)                      ad(h) a = [h, a]
///   G::T(h), G::Tinv(h)           right Jacobian:  H^-1 dH = (T(h) dh)~  for H = exp(h)
///   G::dT(h, a)                   D_h [T(h) a]       [dim x dim]
///   G::dTinv(h, a)                D_h [T^-1(h) a]    [dim x dim]
///   G::dTinvT(h, n)               D_h [T^-T(h) n]    [dim x dim]
template <class G>
concept LieGroup = requires(const G H, const typename G::Tangent h) {
  { G::dim } -> std::convertible_to<int>;
  { G::identity() } -> std::same_as<G>;
  { H* H } -> std::same_as<G>;
  { H.inverse() } -> std::same_as<G>;
  { G::exp(h) } -> std::same_as<G>;
  { G::log(H) } -> std::same_as<typename G::Tangent>;
  { H.Ad() } -> std::convertible_to<typename G::Matrix>;
  { G::ad(h) } -> std::convertible_to<typename G::Matrix>;
  { G::T(h) } -> std::convertible_to<typename G::Matrix>;
  { G::Tinv(h) } -> std::convertible_to<typename G::Matrix>;
  { G::dT(h, h) } -> std::convertible_to<typename G::Matrix>;
  { G::dTinv(h, h) } -> std::convertible_to<typename G::Matrix>;
  { G::dTinvT(h, h) } -> std::convertible_to<typename G::Matrix>;
};

/// A group of frames: a rotation R and a position x of a space of `space_dim` dimensions.
/// SE(2) and SE(3); bodies and couplings are written once for both.
template <class G>
concept FrameGroup = LieGroup<G> && requires(const G H) {
  { G::space_dim } -> std::convertible_to<int>;     // 2 or 3
  { G::rotation_dim } -> std::convertible_to<int>;  // 1 or 3
  H.R;                                              // space_dim x space_dim
  H.x;                                              // space_dim
};

}  // namespace liesl
