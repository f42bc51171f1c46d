#pragma once
/// @file
/// What a picture needs beside the motion: shapes at rest, sections, places of joints.

#include "apps/output/results.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// The numbers of the column or row v after those of `out`.
template <class Vector>
void append(std::vector<double>& out, const Eigen::MatrixBase<Vector>& v) {
  EIGEN_STATIC_ASSERT_VECTOR_ONLY(Vector)
  const std::size_t size = out.size();
  out.resize(size + static_cast<std::size_t>(v.size()));
  const auto last = static_cast<Eigen::Index>(out.size()), first = static_cast<Eigen::Index>(size);
  for (Eigen::Index i = first; i < last; ++i) out[static_cast<std::size_t>(i)] = v[i - first];
}

/// Fills in frames at rest (those of the state `rest`), sections, points and ports.
template <FrameGroup G>
void add_reference(const Mechanism& mechanism, const Model<G>& model, const State<G>& rest,
                   output::Results& results);

extern template void add_reference(const Mechanism&, const Model<SE2>&, const State<SE2>&,
                                   output::Results&);
extern template void add_reference(const Mechanism&, const Model<SE3>&, const State<SE3>&,
                                   output::Results&);

}  // namespace liesl
