#pragma once
/// @file
/// Values of named responses at a state.

#include <map>
#include <vector>

#include "mbs/model/response.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {

/// Number of components of a response: 1, 2 (deflection in space) or 3.
int components(const ResponseSpec& response, bool planar);
/// "deflection", ...: as a scene calls it.
const char* name_of(ResponseKind kind);
/// SI unit of a response.
const char* unit(const ResponseSpec& response, const Mechanism& mechanism);

/// Offset of the point s of a beam from its chord, along the chord's normals (y, z), m: y is the
/// section's y axis at node 0 made normal to the chord. `nodes` are the beam's spatial frames.
Eigen::Vector2d chord_offset(const std::vector<SE3>& nodes, double s);

/// Evaluates responses on a model of the mechanism.
template <FrameGroup G>
class ResponseValues {
 public:
  ResponseValues(const Mechanism& mechanism, const Model<G>& model);

  /// Value of a response, `components` numbers. Only H, v, lambda and q of the state are used.
  /// Not for several threads at once: what depends on the sections alone is kept.
  Eigen::VectorXd operator()(const ResponseSpec& response, const State<G>& s) const;

 private:
  /// Of the point `place` of a beam whose frames are `now`.
  Eigen::Vector2d deflection(int body, const std::vector<SE3>& now, double place) const;
  double elongation(const ResponseSpec& r, const State<G>& s) const;
  double stress(const ResponseSpec& r, const State<G>& s) const;
  std::vector<SE3> nodes(const G* H, int body) const;
  const std::vector<std::vector<StressPoint>>& points_of(int body) const;

  const Mechanism& mechanism_;
  const Model<G>& model_;
  SpatialView<G> view_;
  /// Of the beams whose stress was asked for: by body and element.
  mutable std::map<int, std::vector<std::vector<StressPoint>>> stress_points_;
};

/// Force and moment [6] that a joint transmits to its port b, in b's own axes; and the coordinates
/// of a joint. `joint` counts the joints of the mechanism.
template <FrameGroup G>
SE3::Tangent joint_force(const Mechanism& mechanism, const Model<G>& model, int joint,
                         const State<G>& s);
template <FrameGroup G>
std::vector<double> joint_coordinates(const Mechanism& mechanism, const Model<G>& model, int joint,
                                      const State<G>& s);

extern template class ResponseValues<SE2>;
extern template class ResponseValues<SE3>;
extern template SE3::Tangent joint_force(const Mechanism&, const Model<SE2>&, int,
                                         const State<SE2>&);
extern template SE3::Tangent joint_force(const Mechanism&, const Model<SE3>&, int,
                                         const State<SE3>&);
extern template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE2>&, int,
                                                      const State<SE2>&);
extern template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE3>&, int,
                                                      const State<SE3>&);

}  // namespace liesl
