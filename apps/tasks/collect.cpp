#include "apps/tasks/collect.hpp"

#include <algorithm>
#include <cmath>

#include "apps/scene/reader.hpp"
#include "apps/tasks/body_series.hpp"
#include "apps/tasks/collect_mesh.hpp"
#include "apps/tasks/collect_reference.hpp"
#include "apps/tasks/displacement_basis.hpp"
#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/system/energy.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

output::BodyResult empty_body(const BodySpec& spec) {
  output::BodyResult body;
  body.name = spec.name;
  body.kind = "rigid";
  body.nodes = 1;
  if (const auto* solid = std::get_if<SolidSpec>(&spec.kind)) {
    body.kind = "solid";
    body.nodes = static_cast<int>(solid->interfaces().size());
  }
  if (const auto* beam = std::get_if<BeamSpec>(&spec.kind)) {
    body.kind = "beam";
    body.nodes = static_cast<int>(beam->nodes.size());
    for (int e = 0; e + 1 < body.nodes; ++e) body.elements.push_back({e, e + 1});
  }
  return body;
}

output::JointResult empty_joint(const JointSpec& spec) {
  output::JointResult joint;
  joint.name = spec.name;
  joint.type = kind_of(spec.type).name;
  return joint;
}

constexpr double kShownTo = 1e-6;  // of the size of a part, to which its displacements are shown
constexpr double kStretch = 1e-3, kNoise = 1e-9;  // stress below is round-off, of its modulus
constexpr double kStressTo = 1e-2;  // of its largest stress, to which stresses of continua are

/// Displacements of the nodes of a meshed part in the axes of its mesh, seen from the first
/// interface: u = phi amplitudes at every record.
struct MeshMotion {
  Eigen::MatrixXd phi;  ///< node freedoms x k; no columns: it is rigid
  std::vector<Eigen::VectorXd> amplitudes;
  /// Of a continuum: stresses of the cells below each other by amplitude, Pa.
  Eigen::MatrixXd stress = {};
  double largest_stress = 0;  ///< component of a continuum, Pa
};

/// Of a continuum: displacements with the stresses below them, which do not follow from those by
/// amplitude, in a basis found on the way. @param turn axes of the mesh to those of its ports
template <FrameGroup G>
MeshMotion motion_of(const ContinuumBody<G>& body, const Model<G>& model,
                     const Trajectory<G>& trajectory, int b, const Eigen::Matrix3d& turn) {
  constexpr int sd = G::space_dim;
  using Points = typename ContinuumBody<G>::Points;
  const Eigen::Matrix<double, sd, sd> axes = turn.topLeftCorner<sd, sd>();
  const auto seen = [&](const G* H) {
    Points x;
    body.positions(H, x);
    return Points((H[0].R * axes).transpose() * (x.colwise() - H[0].x));
  };
  const auto at = [&](int n) { return seen(trajectory.frames(n) + model.first_node(b)); };
  const Points rest = seen(body.reference.data());
  const double tolerance = kShownTo * rest.cwiseAbs().maxCoeff();
  double largest = 0;
  for (int n = 0; n < trajectory.size(); ++n)
    largest = std::max(largest, body.stresses_at(at(n)).cwiseAbs().maxCoeff());
  const double modulus = body.stresses_at((1 + kStretch) * rest).cwiseAbs().maxCoeff() / kStretch;
  const double scale = tolerance / (kStressTo * std::max(largest, kNoise * modulus));
  MeshMotion out;
  out.largest_stress = largest;
  const Eigen::MatrixXd none = body.stresses_at(rest);
  DisplacementBasis basis(rest.size() + none.size(), tolerance);
  for (int n = 0; n < trajectory.size(); ++n) {
    const Points x = at(n), u = x - rest;
    const Eigen::MatrixXd stress = scale * body.stresses_at(x);
    Eigen::VectorXd both(rest.size() + none.size());
    both << u.reshaped(), stress.reshaped();
    out.amplitudes.push_back(basis.amplitudes(both));
  }
  out.phi = basis.basis().topRows(rest.size());
  out.stress = basis.basis().bottomRows(none.size()) / scale;
  return out;
}

/// Of a reduced part: T Psi e.
template <FrameGroup G>
MeshMotion motion_of(const SolidBody<G>& body, const Model<G>& model,
                     const Trajectory<G>& trajectory, int b) {
  MeshMotion out{body.model().displacements(body.basis()), {}};
  State<G> s = model.initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    out.amplitudes.push_back(body.coordinates(model.body_state(s, b)));
  }
  return out;
}

/// Positions of the nodes of a meshed part, x_0 + R_0 (s + u), and of that R_0 u with u = phi e, at
/// the records that are shown.
/// @param result takes the largest stress of a continuum
template <FrameGroup G>
output::MeshResult mesh_of(const Mechanism& mechanism, const Model<G>& model,
                           const Trajectory<G>& trajectory, int b, output::BodyResult& result) {
  const BodySpec& spec = mechanism.bodies[static_cast<size_t>(b)];
  const SolidMesh& mesh = std::get<SolidSpec>(spec.kind).mesh();
  const Body<G>& body = *model.bodies[static_cast<size_t>(b)];
  MeshMotion motion;
  if (const auto* solid = SolidBody<G>::of(body)) motion = motion_of(*solid, model, trajectory, b);
  output::MeshResult out = mesh_at_rest(spec, motion.phi);
  if (const auto* continuum = ContinuumBody<G>::of(body)) {
    const SE3 align = model.space.alignment(std::get<SolidSpec>(spec.kind).frame);
    motion = motion_of(*continuum, model, trajectory, b, align.R);
    add_basis(mesh, motion.phi, out);
    for (Eigen::Index k = 0; k < motion.stress.cols(); ++k)
      append(out.stress_basis, motion.stress.col(k));
  }
  result.largest_stress = motion.largest_stress;
  out.records = output::spread_records(trajectory.size(), output::kShownRecords);
  const SpatialView<G> view(mechanism, model);
  if (48.0 * static_cast<double>(out.records.size()) * mesh.node_count() > output::kMeshBytes)
    out.records.clear();
  for (Eigen::VectorXd& e : motion.amplitudes) {
    const Eigen::Index known = e.size();
    e.conservativeResize(motion.phi.cols());
    e.tail(e.size() - known).setZero();
    append(out.amplitudes, e);
  }
  const Eigen::Vector3d origin = std::get<SolidSpec>(spec.kind).interfaces()[0].point;
  State<G> s = model.initial_state();
  for (const int n : out.records) {
    trajectory.read(n, s);
    const SE3 H = view.node(s.H.data(), b, 0);
    Eigen::Matrix3Xd x = mesh.nodes.colwise() - origin;
    Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, x.cols());
    if (motion.phi.cols() > 0) {
      const Eigen::VectorXd q = motion.phi * motion.amplitudes[static_cast<size_t>(n)];
      u.topRows(mesh.dim) = Eigen::Map<const Eigen::MatrixXd>(q.data(), mesh.dim, x.cols());
    }
    x = ((H.R * (x + u)).colwise() + H.x).eval();
    u = (H.R * u).eval();
    append(out.positions, Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()));
    append(out.displacements, Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()));
  }
  return out;
}

template <FrameGroup G>
double constraint_residual(const Model<G>& model, const State<G>& s, double t) {
  double largest = 0, before = 0;  // of the coupling that the next may continue
  for (size_t k = 0; k < model.couplings.size(); ++k) {
    const auto& c = model.couplings[k];
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const auto& e = c.rows[i];
      if (e.role != Role::Constraint && e.role != Role::Redundant) continue;
      double off = s.rows[c.first_row + static_cast<int>(i)] - e.target(t);
      if (c.continued) off += before;
      before = off;
      if (k + 1 < model.couplings.size() && model.couplings[k + 1].continued) continue;
      largest = std::max(largest, std::abs(off));
    }
  }
  return largest;
}

/// Letters of the components of a deflection: those across the beam, of which a plane has one.
template <FrameGroup G>
std::string axes_of(const ResponseSpec& r, const ResponseValues<G>& values) {
  if (r.kind != ResponseKind::Deflection || r.everywhere) return {};
  return G::space_dim == 3 ? "yz" : values.in_plane(r.body) == 0 ? "y" : "z";
}

template <FrameGroup G>
std::vector<output::ResponseResult> empty_responses(const std::vector<ResponseSpec>& specs,
                                                    const Mechanism& mechanism,
                                                    const ResponseValues<G>& values) {
  std::vector<output::ResponseResult> out;
  for (const auto& r : specs) {
    const int count = components(r, G::space_dim == 2);
    out.push_back({r.name, unit(r, mechanism), count, {}, axes_of(r, values), {}});
  }
  return out;
}

template <FrameGroup G>
double total_mass(const Model<G>& model) {
  double mass = 0;
  for (const auto& body : model.bodies) mass += body->total_mass();
  return mass;
}

}  // namespace

template <FrameGroup G>
StepRecorder<G>::StepRecorder(const Scene& scene, const Mechanism& mechanism, const Model<G>& model)
    : model_(model),
      specs_(scene.responses),
      dynamic_(scene.simulation.type == SimulationType::Dynamic),
      values_(mechanism, model),
      equations_(model),
      of_penalties_(model),
      responses_(empty_responses(scene.responses, mechanism, values_)),
      peaks_(responses_.size()),
      crossing_(0.5 * total_mass(model) * std::pow(mechanism.size(), 2)) {}

template <FrameGroup G>
void StepRecorder<G>::operator()(const State<G>& s, bool recorded) {
  add_responses(s, recorded);
  add_energies(s, recorded);
  ++states_;
}

template <FrameGroup G>
void StepRecorder<G>::add_responses(const State<G>& s, bool recorded) {
  for (size_t i = 0; i < specs_.size(); ++i) {
    const Eigen::VectorXd y = values_(specs_[i], s);
    output::ResponseResult& out = responses_[i];
    if (recorded) append(out.values, y);
    if (add_to_peak(out, peaks_[i], {s.t, y.norm()}))
      out.peak->between = values_.above_the_nodes(specs_[i], s);
  }
}

template <FrameGroup G>
bool StepRecorder<G>::add_to_peak(output::ResponseResult& out, Peaks& peaks,
                                  const Sample& now) const {
  const bool over_two = dynamic_ && states_ > 1;
  if (over_two && peaks.last.value >= peaks.before.value && peaks.last.value >= now.value)
    peaks.vertex =
        std::max(peaks.vertex, peaks.last.value + vertex_above(peaks.before, peaks.last, now));
  peaks.before = peaks.last;
  peaks.last = now;
  const bool largest = !out.peak || now.value > out.peak->size;
  if (largest) out.peak = output::Peak{now.value, now.at};
  out.peak->missed = std::max(0.0, peaks.vertex - out.peak->size);
  return largest;
}

/// Of the weight as its factor changes.
template <FrameGroup G>
void StepRecorder<G>::add_work_of_gravity(const State<G>& s) {
  const double scale = model_.gravity_scale(s.t), potential = weight_potential(model_, s);
  if (states_ > 0) work_ += 0.5 * (scale - scale_before_) * (potential + weight_before_);
  scale_before_ = scale;
  weight_before_ = potential;
}

/// Work by the trapezoidal rule over the steps that are shown.
template <FrameGroup G>
void StepRecorder<G>::add_energies(const State<G>& s, bool recorded) {
  const BodyEnergy e = mechanical_energy(model_, s);
  double dissipated = 0;
  if (dynamic_) {
    const double p = power(model_, equations_, s);
    if (states_ == 0) start_ = total(e);
    if (states_ > 0) work_ += 0.5 * (s.t - t_before_) * (p + power_before_);
    work_ += of_penalties_.step(s);
    if (!model_.gravity_scale.is_constant()) add_work_of_gravity(s);
    t_before_ = s.t;
    power_before_ = p;
    dissipated = start_ + work_ - total(e);
  }
  output::Energies& out = energies_;
  out.turned_over = std::max(out.turned_over, e.kinetic + e.elastic);
  if (s.t > 0) out.crossing = crossing_ / (s.t * s.t);
  out.largest_potential = std::max(out.largest_potential, std::abs(e.potential));
  if (std::abs(dissipated) > std::abs(out.lost)) out.lost = dissipated;
  if (!recorded) return;
  out.kinetic.push_back(e.kinetic);
  out.elastic.push_back(e.elastic);
  out.potential.push_back(e.potential);
  out.total.push_back(total(e));
  if (dynamic_) out.dissipated.push_back(dissipated);
}

template <FrameGroup G>
std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>& responses,
                                                      const Mechanism& mechanism,
                                                      const Model<G>& model,
                                                      const Trajectory<G>& trajectory) {
  const ResponseValues<G> values(mechanism, model);
  auto out = empty_responses(responses, mechanism, values);
  State<G> s = model.initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    for (size_t i = 0; i < responses.size(); ++i) append(out[i].values, values(responses[i], s));
  }
  return out;
}

namespace {

/// Where bodies of one node are.
template <FrameGroup G>
void add_places(const SpatialView<G>& view, const State<G>& s, output::Results& r) {
  for (size_t b = 0; b < r.bodies.size(); ++b)
    if (r.bodies[b].nodes == 1)
      append(r.bodies[b].path, view.node(s.H.data(), static_cast<int>(b), 0).x);
}

}  // namespace

template <FrameGroup G>
output::Results collect(const Scene& scene, const Mechanism& mechanism, const Model<G>& model,
                        const Trajectory<G>& trajectory, const StepRecorder<G>* seen,
                        output::BodySink* sink) {
  output::Results r;
  r.name = mechanism.name;
  r.space = G::space_dim == 2 ? "planar" : "spatial";
  const bool dynamic = scene.simulation.type == SimulationType::Dynamic;
  if (!dynamic) {
    r.abscissa = "load_factor";
    r.abscissa_unit = "-";
  }
  for (const auto& body : mechanism.bodies) r.bodies.push_back(empty_body(body));
  for (const auto& j : mechanism.joints) r.joints.push_back(empty_joint(j));

  for (size_t b = 0; b < mechanism.bodies.size(); ++b)
    if (std::holds_alternative<SolidSpec>(mechanism.bodies[b].kind))
      r.meshes.push_back(mesh_of(mechanism, model, trajectory, static_cast<int>(b), r.bodies[b]));

  State<G> s = model.initial_state();
  model.complete(s);
  const auto records = static_cast<size_t>(trajectory.size());
  BodySeries<G> series(mechanism, model, records, sink, r);
  add_reference(mechanism, model, s, r);
  r.times.reserve(records);
  StepRecorder<G> of_records(scene, mechanism, model);
  const SpatialView<G> view(mechanism, model);
  const auto of_paths = output::spread_records(trajectory.size(), output::kPathPoints);
  const bool all_steps = seen && !seen->empty();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    r.times.push_back(s.t);
    series.add(s);
    if (std::binary_search(of_paths.begin(), of_paths.end(), n)) add_places(view, s, r);
    for (size_t j = 0; j < r.joints.size(); ++j) {
      const auto q = joint_coordinates(mechanism, model, static_cast<int>(j), s);
      append(r.joints[j].coordinates,
             Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<long>(q.size())));
      append(r.joints[j].forces, joint_force(mechanism, model, static_cast<int>(j), s));
      if (n == 0)
        for (size_t k = 0; k < q.size(); ++k) {
          ResponseSpec spec;
          spec.kind = ResponseKind::Coordinate;
          spec.joint = static_cast<int>(j);
          spec.coordinate = static_cast<int>(k);
          r.joints[j].units.push_back(unit(spec, mechanism));
        }
    }
    if (!all_steps) of_records(s, true);
    r.constraint_residual.push_back(
        constraint_residual(model, s, dynamic ? s.t : scene.simulation.at));
  }
  const StepRecorder<G>& steps = all_steps ? *seen : of_records;
  r.energies = steps.energies();
  r.responses = steps.responses();
  for (size_t i = 0; i < std::min(r.responses.size(), output::kPeaks); ++i)
    if (r.responses[i].peak && records > 0)
      r.peaks.push_back(r.record_near(r.responses[i].peak->at));
  for (const int record : r.peaks) {
    trajectory.read(record, s);
    series.keep_also(record, s);
  }
  return r;
}

template class StepRecorder<SE2>;
template class StepRecorder<SE3>;
template output::Results collect(const Scene&, const Mechanism&, const Model<SE2>&,
                                 const Trajectory<SE2>&, const StepRecorder<SE2>*,
                                 output::BodySink*);
template output::Results collect(const Scene&, const Mechanism&, const Model<SE3>&,
                                 const Trajectory<SE3>&, const StepRecorder<SE3>*,
                                 output::BodySink*);
template std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>&,
                                                               const Mechanism&, const Model<SE2>&,
                                                               const Trajectory<SE2>&);
template std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>&,
                                                               const Mechanism&, const Model<SE3>&,
                                                               const Trajectory<SE3>&);

}  // namespace liesl
