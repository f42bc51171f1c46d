#pragma once
/// @file
/// The limits on one part as linear outputs of its static problem, y = C^T u, and what the motion
/// says of the same outputs.

#include <Eigen/Core>
#include <vector>

#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// A limit on |outputs first .. first + count) of a part, or on the von Mises stress made of them.
struct Limit {
  int constraint = 0;  ///< of the study
  int part = 0;        ///< which of the limited parts
  int first = 0, count = 0;
  int element = -1, point = -1;  ///< stress: the outputs are the strain of this element, the point
                                 ///< is that of `ElementStress`
  int node = -1;                 ///< a deflection `everywhere`: of this node
};

struct PartOutputs {
  std::vector<Limit> limits;
  Eigen::MatrixXd C;        ///< size of the body x outputs: gradients at the reference shape
  bool compliance = false;  ///< one more output after those: load times displacement
  int count() const { return static_cast<int>(C.cols()) + compliance; }
};

/// The response whose size this limit bounds: `limited` at one node or stress point of a beam.
ResponseSpec response_of(const Limit& limit, const ResponseSpec& limited, int elements);

/// Deflections, displacements and elongations are outputs themselves; stresses at the end of an
/// element have its strain as outputs, which all points of that section share.
template <FrameGroup G>
PartOutputs limited_outputs(const StudySpec& study, const Mechanism& mechanism,
                            const Model<G>& model, int body);

/// The outputs as the motion has them: outputs x records. Those of a stress are the strain that has
/// the section force of the motion at that end of the element.
template <FrameGroup G>
Eigen::MatrixXd dynamic_outputs(const PartOutputs& outputs, const StudySpec& study,
                                const Mechanism& mechanism, const Model<G>& model,
                                const Trajectory<G>& trajectory, int body);

extern template PartOutputs limited_outputs(const StudySpec&, const Mechanism&, const Model<SE2>&,
                                            int);
extern template PartOutputs limited_outputs(const StudySpec&, const Mechanism&, const Model<SE3>&,
                                            int);
extern template Eigen::MatrixXd dynamic_outputs(const PartOutputs&, const StudySpec&,
                                                const Mechanism&, const Model<SE2>&,
                                                const Trajectory<SE2>&, int);
extern template Eigen::MatrixXd dynamic_outputs(const PartOutputs&, const StudySpec&,
                                                const Mechanism&, const Model<SE3>&,
                                                const Trajectory<SE3>&, int);

}  // namespace liesl
