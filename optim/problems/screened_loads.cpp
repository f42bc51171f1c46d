#include "optim/problems/screened_loads.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include "esl/load_patches.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/system/spatial_view.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {
namespace {

using Load = CycleLoads::Load;

/// The loads of a beam at record n.
template <FrameGroup G>
Load beam_load(const SpatialView<G>& view, const LoadSet& set, int n) {
  Load load(6, set.f.rows() / G::dim);
  for (Eigen::Index k = 0; k < load.cols(); ++k)
    load.col(k) = view.local(set.f.col(n).template segment<G::dim>(G::dim * k), set.body,
                             static_cast<int>(k));
  return load;
}

/// The loads on the interfaces of a meshed part at record n, then those on its patches.
Load part_load(const SolidModel& model, const LoadPatches& patches, const SolidLoadSet& set,
               int n) {
  const Eigen::VectorXd f = set.load(n);
  const int dim = model.mesh().dim, turns = model.rigid_count() - dim;
  Load load = Load::Zero(6, model.ports() + patches.places.cols());
  for (int k = 0; k < model.ports(); ++k) {
    load.col(k).head(dim) = f.segment(model.port(k), dim);
    load.col(k).tail(turns) = f.segment(model.port(k) + dim, turns);
  }
  load.rightCols(patches.places.cols()) = patches.of(f);
  return load;
}

/// The largest of the maxima over time, and the record `worst` (-1: none); none if there is no load
/// at all.
std::vector<int> kept_records(const std::vector<double>& sizes, int worst) {
  if (sizes.empty() || !(*std::max_element(sizes.begin(), sizes.end()) > 0)) return {};
  const std::set<int> maxima = treated_records(Treatment::Maxima, sizes);
  std::vector<int> kept(maxima.begin(), maxima.end());
  std::stable_sort(kept.begin(), kept.end(),
                   [&](int a, int b) { return sizes[std::size_t(a)] > sizes[std::size_t(b)]; });
  std::erase(kept, worst);
  kept.resize(std::min(kept.size(), worst < 0 ? kKeptLoads : kKeptLoads - 1));
  if (worst >= 0) kept.push_back(worst);
  std::sort(kept.begin(), kept.end());
  return kept;
}

/// @param points how many, the first, tell the size: all of a beam, interfaces of a meshed part
/// @param load_at record -> loads
template <class LoadAt>
void add_part(int body, int scenario, int worst, const std::vector<double>& times, double length,
              Eigen::Index points, const LoadAt& load_at, std::vector<CycleLoads>& out) {
  std::vector<double> sizes;
  for (std::size_t n = 0; n < times.size(); ++n) {
    const Load load = load_at(static_cast<int>(n)).leftCols(points);
    sizes.push_back(std::hypot(load.topRows<3>().norm(), load.bottomRows<3>().norm() / length));
  }
  CycleLoads part{body, scenario, {}, {}};
  for (const int n : kept_records(sizes, worst)) {
    part.times.push_back(times[std::size_t(n)]);
    part.loads.push_back(load_at(n));
  }
  if (!part.times.empty()) out.push_back(std::move(part));
}

/// Record where the limit is largest that is nearest to its bound, or furthest beyond; -1: none.
template <FrameGroup G>
int worst_record(const DesignRun<G>& run) {
  for (const LimitSeries& limit : run.limits)
    if (limit.name == run.worst_constraint && !limit.values.empty())
      return static_cast<int>(std::max_element(limit.values.begin(), limit.values.end()) -
                              limit.values.begin());
  return -1;
}

}  // namespace

template <FrameGroup G>
std::vector<CycleLoads> screened_loads(const DesignRun<G>& run, int scenario) {
  std::vector<CycleLoads> out;
  if (!run.good()) return out;
  const SpatialView<G> view(run.mechanism, *run.model);
  const int worst = worst_record(run);
  for (const LoadSet& set : run.loads)
    add_part(
        set.body, scenario, worst, set.t, run.model->length, set.f.rows() / G::dim,
        [&](int n) { return beam_load<G>(view, set, n); }, out);
  for (const SolidLoadSet& set : run.solid_loads) {
    const auto& spec = std::get<SolidSpec>(run.mechanism.bodies[std::size_t(set.body)].kind);
    const LoadPatches patches = load_patches(*spec.model);
    add_part(
        set.body, scenario, worst, set.t, run.model->length, spec.model->ports(),
        [&](int n) { return part_load(*spec.model, patches, set, n); }, out);
  }
  return out;
}

template std::vector<CycleLoads> screened_loads(const DesignRun<SE2>&, int);
template std::vector<CycleLoads> screened_loads(const DesignRun<SE3>&, int);

}  // namespace liesl
