#include "apps/tasks/collect.hpp"

#include "apps/scene/reader.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/system/energy.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

void append(std::vector<double>& out, const Eigen::Ref<const Eigen::VectorXd>& v) {
  out.insert(out.end(), v.data(), v.data() + v.size());
}

output::BodyResult empty_body(const BodySpec& spec) {
  output::BodyResult body;
  body.name = spec.name;
  body.kind = "rigid";
  body.nodes = 1;
  if (const auto* solid = std::get_if<SolidSpec>(&spec.kind)) {
    body.kind = "solid";
    body.nodes = static_cast<int>(solid->interfaces.size());
  }
  if (const auto* beam = std::get_if<BeamSpec>(&spec.kind)) {
    body.kind = "beam";
    body.nodes = static_cast<int>(beam->nodes.size());
    for (int e = 0; e + 1 < body.nodes; ++e) body.elements.push_back({e, e + 1});
  }
  return body;
}

template <FrameGroup G>
void add_body(const Model<G>& model, const SpatialView<G>& view, int b, const State<G>& s,
              output::BodyResult& out) {
  for (int k = 0; k < out.nodes; ++k) {
    const SE3 H = view.node(s.H.data(), b, k);
    append(out.positions, H.x);
    for (int i = 0; i < 3; ++i) append(out.rotations, H.R.row(i).transpose());
    append(out.velocities, view.velocity(s.v.data(), {b, k, SE3::identity()}));
  }
  for (size_t e = 0; e < out.elements.size(); ++e) {
    const BodyState<G> state = model.body_state(s, b);
    append(out.strains,
           view.local(model.bodies[b]->strain(state, static_cast<int>(e)), b, static_cast<int>(e)));
    append(out.section_forces,
           view.local(model.bodies[b]->section_force(state, static_cast<int>(e)), b,
                      static_cast<int>(e)));
  }
}

/// Positions of the nodes of a meshed part, x_0 + R_0 (s + u), and of that R_0 u with u = phi e, at
/// the records that are shown.
template <FrameGroup G>
output::MeshResult mesh_of(const Mechanism& mechanism, const Model<G>& model,
                           const Trajectory<G>& trajectory, int b) {
  const auto& solid = std::get<SolidSpec>(mechanism.bodies[b].kind);
  const auto* body = dynamic_cast<const SolidBody<G>*>(model.bodies[b].get());  // null: rigid
  output::MeshResult out;
  out.name = mechanism.bodies[b].name;
  out.corners = solid.mesh.corners();
  out.cells.assign(solid.mesh.cells.data(), solid.mesh.cells.data() + solid.mesh.cells.size());
  append(out.fractions, solid_fractions(solid).value);
  out.records = output::spread_records(trajectory.size(), output::kShownRecords);
  const SpatialView<G> view(mechanism, model);
  Eigen::MatrixXd phi;
  if (body) phi = solid_model(solid).T() * body->basis();
  const int dim = solid.mesh.dim;
  State<G> s = model.initial_state();
  for (const int n : out.records) {
    trajectory.read(n, s);
    const SE3 H = view.node(s.H.data(), b, 0);
    Eigen::Matrix3Xd x = solid.mesh.nodes.colwise() - solid.interfaces[0].point;
    Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, x.cols());
    if (body) {
      const Eigen::VectorXd q = phi * body->coordinates(model.body_state(s, b));
      u.topRows(dim) = Eigen::Map<const Eigen::MatrixXd>(q.data(), dim, x.cols());
    }
    x = ((H.R * (x + u)).colwise() + H.x).eval();
    u = (H.R * u).eval();
    append(out.positions, Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()));
    append(out.displacements, Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()));
  }
  return out;
}

template <FrameGroup G>
void add_energies(const Model<G>& model, const State<G>& s, output::Energies& out) {
  const BodyEnergy e = mechanical_energy(model, s);
  out.kinetic.push_back(e.kinetic);
  out.elastic.push_back(e.elastic);
  out.potential.push_back(e.potential);
  out.total.push_back(total(e));
}

template <FrameGroup G>
double constraint_residual(const Model<G>& model, const State<G>& s) {
  double largest = 0;
  for (const auto& c : model.couplings)
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const auto& e = c.rows[i];
      if (e.role != Role::Constraint && e.role != Role::Redundant) continue;
      largest =
          std::max(largest, std::abs(s.rows[c.first_row + static_cast<int>(i)] - e.target(s.t)));
    }
  return largest;
}

}  // namespace

template <FrameGroup G>
std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>& responses,
                                                      const Mechanism& mechanism,
                                                      const Model<G>& model,
                                                      const Trajectory<G>& trajectory) {
  const ResponseValues<G> values(mechanism, model);
  std::vector<output::ResponseResult> out;
  State<G> s = model.initial_state();
  for (const auto& r : responses)
    out.push_back({r.name, unit(r, mechanism), components(r, G::space_dim == 2), {}});
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    for (size_t i = 0; i < responses.size(); ++i) append(out[i].values, values(responses[i], s));
  }
  return out;
}

template <FrameGroup G>
output::Results collect(const Scene& scene, const Mechanism& mechanism, const Model<G>& model,
                        const Trajectory<G>& trajectory) {
  output::Results r;
  r.name = mechanism.name;
  r.space = G::space_dim == 2 ? "planar" : "spatial";
  const bool dynamic = scene.simulation.type == SimulationType::Dynamic;
  if (!dynamic) {
    r.abscissa = "load_factor";
    r.abscissa_unit = "-";
  }
  for (const auto& body : mechanism.bodies) r.bodies.push_back(empty_body(body));
  for (const auto& j : mechanism.joints)
    r.joints.push_back({j.name, std::string(kind_of(j.type).name), {}, {}, {}});

  for (size_t b = 0; b < mechanism.bodies.size(); ++b)
    if (std::holds_alternative<SolidSpec>(mechanism.bodies[b].kind))
      r.meshes.push_back(mesh_of(mechanism, model, trajectory, static_cast<int>(b)));

  const SpatialView<G> view(mechanism, model);
  State<G> s = model.initial_state();
  Equations<G> eq(model);
  double work = 0, p_before = 0;
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    r.times.push_back(s.t);
    for (size_t b = 0; b < r.bodies.size(); ++b)
      add_body(model, view, static_cast<int>(b), s, r.bodies[b]);
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
    add_energies(model, s, r.energies);
    if (dynamic) {
      const double p = power(model, eq, s);
      if (n > 0) work += 0.5 * (s.t - r.times[n - 1]) * (p + p_before);
      p_before = p;
      r.energies.dissipated.push_back(r.energies.total.front() + work - r.energies.total.back());
    }
    r.constraint_residual.push_back(constraint_residual(model, s));
  }
  r.responses = collect_responses(scene.responses, mechanism, model, trajectory);
  return r;
}

template output::Results collect(const Scene&, const Mechanism&, const Model<SE2>&,
                                 const Trajectory<SE2>&);
template output::Results collect(const Scene&, const Mechanism&, const Model<SE3>&,
                                 const Trajectory<SE3>&);
template std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>&,
                                                               const Mechanism&, const Model<SE2>&,
                                                               const Trajectory<SE2>&);
template std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>&,
                                                               const Mechanism&, const Model<SE3>&,
                                                               const Trajectory<SE3>&);

}  // namespace liesl
