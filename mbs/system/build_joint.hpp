#pragma once
/// @file
/// Joints on a group of frames, from the table of joint kinds (mbs/model/joint_kind.hpp).

#include <vector>

#include "mbs/system/build_port.hpp"

namespace liesl {

/// Constraints first, then the coordinates that the joint leaves, observed. The port frames have
/// the axes of the plane (or the inertial ones). Rows that every motion in the plane satisfies are
/// left out, as are coordinates out of it.
/// @param distance of the ports in the scene as given, m
/// @throws std::invalid_argument for a screw without pitch, or in a plane
template <FrameGroup G>
std::vector<CouplingRow<G>> joint_rows(const JointSpec& joint, double distance,
                                       const Space<G>& space);

/// Joint number `index` of the mechanism with its drives and the forces on its coordinates.
template <FrameGroup G>
Coupling<G> build_joint(const Mechanism& mechanism, int index, const Space<G>& space,
                        const Ports<G>& ports);

extern template Coupling<SE2> build_joint(const Mechanism&, int, const Space<SE2>&,
                                          const Ports<SE2>&);
extern template Coupling<SE3> build_joint(const Mechanism&, int, const Space<SE3>&,
                                          const Ports<SE3>&);

}  // namespace liesl
