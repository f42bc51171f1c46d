#pragma once
/// @file
/// The series of the bodies of a simulation, record after record.

#include <array>
#include <future>
#include <vector>

#include "apps/output/results.hpp"
#include "apps/tasks/section_stress.hpp"
#include "mbs/system/end_force.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {

/// Positions, rotations, velocities, strains, section forces and stresses of all bodies. They are
/// made by blocks of records: for the results, or for a sink, beside which the results keep only
/// the records that tables show (Results::kept). A sink takes a block while the next is made.
template <FrameGroup G>
class BodySeries {
 public:
  /// @param records how many will be added  @param sink null: the results hold all of them
  /// @param results whose bodies have nodes and elements and no series; outlives this
  BodySeries(const Mechanism& mechanism, const Model<G>& model, std::size_t records,
             output::BodySink* sink, output::Results& results);
  /// The next record. @param s completed
  void add(const State<G>& s);
  /// After the last one: a record that the results shall hold, too. @param s it, completed
  void keep_also(int record, const State<G>& s);

 private:
  using Sizes = std::array<std::size_t, output::kBodySeries.size()>;

  void add_nodes(const State<G>& s, std::size_t b);
  void add_elements(const State<G>& s, std::size_t b);
  /// The block to the sink or the results.
  void hand_over();
  void keep(std::size_t b, std::size_t i);

  const Model<G>& model_;
  SpatialView<G> view_;
  std::vector<SectionStress> stress_;                       ///< by body
  std::vector<EndForce<G>> ends_;                           ///< by body
  std::vector<Sizes> sizes_;                                ///< by body: numbers of a record
  std::vector<typename G::Tangent> strains_;                ///< of a body at a record
  std::vector<std::array<typename G::Tangent, 2>> forces_;  ///< at both ends of its elements
  std::size_t records_, first_ = 0, filled_ = 0, most_ = 1;
  std::vector<output::BodyResult> block_;  ///< records first_ ... first_ + filled_ - 1 of most_
  std::vector<output::BodyResult> given_;  ///< to the sink
  output::BodySink* sink_;
  output::Results& results_;
  std::future<void> taken_;  ///< the block given; the last member, so that it is waited for first
};

extern template class BodySeries<SE2>;
extern template class BodySeries<SE3>;

}  // namespace liesl
