#include "apps/tasks/body_series.hpp"

#include <algorithm>
#include <cstddef>

#include "apps/output/memory_limit.hpp"

namespace liesl {
namespace {

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr std::size_t kBlock = std::size_t{1} << 19;  // bytes: what a processor's cache holds

/// Numbers of a record, in the order of output::kBodySeries.
template <class Sizes>
Sizes sizes_of(const output::BodyResult& body, bool stresses) {
  const std::size_t N = static_cast<std::size_t>(body.nodes), E = body.elements.size();
  return {3 * N, 9 * N, 6 * N, 6 * E, 12 * E, stresses ? 2 * E : 0};
}

}  // namespace

template <FrameGroup G>
BodySeries<G>::BodySeries(const Mechanism& mechanism, const Model<G>& model, std::size_t records,
                          output::BodySink* sink, output::Results& results)
    : model_(model),
      view_(mechanism, model),
      records_(records),
      block_(results.bodies),
      sink_(sink),
      results_(results) {
  std::size_t numbers = 0;
  for (std::size_t b = 0; b < block_.size(); ++b) {
    stress_.emplace_back(mechanism.bodies[b]);
    ends_.emplace_back(model, static_cast<int>(b));
    sizes_.push_back(sizes_of<Sizes>(block_[b], !stress_[b].empty()));
    for (const std::size_t size : sizes_[b]) numbers += size;
  }
  most_ = std::clamp(kBlock / (sizeof(double) * std::max<std::size_t>(numbers, 1)), std::size_t{1},
                     std::max<std::size_t>(records, 1));
  if (sink) results.kept = output::spread_records(static_cast<int>(records), output::kFrames);
  const std::size_t held = sink ? results.kept.size() : records;
  for (std::size_t b = 0; b < block_.size(); ++b)
    for (std::size_t i = 0; i < sizes_[b].size(); ++i) {
      (block_[b].*output::kBodySeries[i]).resize(most_ * sizes_[b][i]);
      (results.bodies[b].*output::kBodySeries[i]).reserve(held * sizes_[b][i]);
    }
  if (sink) given_ = block_;
}

template <FrameGroup G>
void BodySeries<G>::add(const State<G>& s) {
  for (std::size_t b = 0; b < block_.size(); ++b) {
    add_nodes(s, b);
    add_elements(s, b);
  }
  ++filled_;
  if (filled_ == most_ || first_ + filled_ == records_) hand_over();
}

template <FrameGroup G>
void BodySeries<G>::add_nodes(const State<G>& s, std::size_t b) {
  output::BodyResult& out = block_[b];
  const int body = static_cast<int>(b), first = model_.first_node(body);
  const std::size_t at = filled_ * static_cast<std::size_t>(out.nodes);
  double *x = out.positions.data() + 3 * at, *R = out.rotations.data() + 9 * at,
         *v = out.velocities.data() + 6 * at;
  for (int k = 0; k < out.nodes; ++k, x += 3, R += 9, v += 6) {
    const SE3 H = view_.node(s.H.data(), body, k);
    const typename G::Tangent velocity = s.v.template segment<G::dim>(G::dim * (first + k));
    Eigen::Map<Eigen::Vector3d>{x} = H.x;
    Eigen::Map<Rows>{R} = H.R;
    Eigen::Map<SE3::Tangent>{v} = view_.local(velocity, body, k);
  }
}

template <FrameGroup G>
void BodySeries<G>::add_elements(const State<G>& s, std::size_t b) {
  output::BodyResult& out = block_[b];
  const std::size_t E = out.elements.size();
  if (E == 0) return;
  const int body = static_cast<int>(b);
  const BodyState<G> state = model_.body_state(s, body);
  const typename G::Tangent none = G::Tangent::Zero();  // of a rigid body
  const auto size = std::max(E, static_cast<std::size_t>(model_.bodies[b]->elements()));
  strains_.assign(size, none);
  forces_.assign(size, {none, none});
  model_.bodies[b]->all_strains(state, strains_.data());
  ends_[b].all(*model_.bodies[b], state, forces_.data());
  const SectionStress& stress = stress_[b];
  double *strain = out.strains.data() + 6 * E * filled_,
         *force = out.section_forces.data() + 12 * E * filled_,
         *sigma = stress.empty() ? nullptr : out.stresses.data() + 2 * E * filled_;
  double& largest = results_.bodies[b].largest_stress;
  for (std::size_t e = 0; e < E; ++e, strain += 6) {
    const int element = static_cast<int>(e);
    Eigen::Map<SE3::Tangent>{strain} = view_.local(strains_[e], body, element);
    for (const auto end : {ElementPlace::First, ElementPlace::Last}) {
      const int node = node_of(end);
      const SE3::Tangent n =
          view_.local(forces_[e][static_cast<std::size_t>(node)], body, element + node);
      Eigen::Map<SE3::Tangent>{force} = n;
      force += 6;
      if (stress.empty()) continue;
      *sigma = stress(e, end, n);
      largest = std::max(largest, *sigma++);
    }
  }
}

template <FrameGroup G>
void BodySeries<G>::hand_over() {
  for (std::size_t b = 0; b < block_.size(); ++b)
    for (std::size_t i = 0; i < sizes_[b].size(); ++i) {
      (block_[b].*output::kBodySeries[i]).resize(filled_ * sizes_[b][i]);
      keep(b, i);
    }
  if (taken_.valid()) taken_.get();
  const std::size_t first = first_, filled = filled_;
  first_ += filled_;
  filled_ = 0;
  if (!sink_) return;
  block_.swap(given_);
  taken_ = std::async(output::beside(),
                      [this, first, filled] { sink_->put(given_, first, filled, records_); });
  if (first_ == records_) taken_.get();
}

/// Of the block's records, those that the results hold.
template <FrameGroup G>
void BodySeries<G>::keep(std::size_t b, std::size_t i) {
  const std::size_t size = sizes_[b][i];
  const auto& from = block_[b].*output::kBodySeries[i];
  auto& to = results_.bodies[b].*output::kBodySeries[i];
  if (!sink_) to.insert(to.end(), from.begin(), from.end());
  for (const int record : results_.kept) {
    const std::size_t row = static_cast<std::size_t>(record) - first_;  // huge before the block
    if (row >= filled_) continue;
    const double* const at = from.data() + row * size;
    to.insert(to.end(), at, at + size);
  }
}

template <FrameGroup G>
void BodySeries<G>::keep_also(int record, const State<G>& s) {
  std::vector<int>& kept = results_.kept;
  const auto at = std::lower_bound(kept.begin(), kept.end(), record);
  if (!sink_ || (at != kept.end() && *at == record)) return;
  const auto row = static_cast<std::size_t>(at - kept.begin());
  kept.insert(at, record);
  for (std::size_t b = 0; b < block_.size(); ++b) {
    for (std::size_t i = 0; i < sizes_[b].size(); ++i)
      (block_[b].*output::kBodySeries[i]).resize(sizes_[b][i]);
    add_nodes(s, b);
    add_elements(s, b);
    for (std::size_t i = 0; i < sizes_[b].size(); ++i) {
      const auto& from = block_[b].*output::kBodySeries[i];
      auto& to = results_.bodies[b].*output::kBodySeries[i];
      to.insert(to.begin() + static_cast<std::ptrdiff_t>(row * sizes_[b][i]), from.begin(),
                from.end());
    }
  }
}

template class BodySeries<SE2>;
template class BodySeries<SE3>;

}  // namespace liesl
