#include "mbs/system/build_body.hpp"

#include <stdexcept>
#include <type_traits>

#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/coupled_mass_body.hpp"
#include "mbs/bodies/modal.hpp"
#include "mbs/bodies/rigid.hpp"
#include "mbs/bodies/segment_beam.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/bodies/spatial_segment_beam.hpp"
#include "mbs/model/beam_order.hpp"
#include "mbs/model/parameter.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/system/body_law.hpp"

namespace liesl {
namespace {

/// What a beam of fourth order cannot be is refused.
void refuse_order_4(const std::string& name, const BeamSpec& beam, Formalism formalism) {
  const auto objections = against_order_4(beam, formalism);
  if (objections.empty()) return;
  const OrderObjection& first = objections.front();
  throw std::invalid_argument("beam '" + name + "' of order 4 " + first.what + "; expected " +
                              first.expected);
}

template <class G>
std::unique_ptr<Body<G>> make_segments(const std::string& name, std::vector<G> nodes,
                                       const std::vector<ElementSection<G>>& sections,
                                       double damping, const SegmentSpec& spec) {
  using Chain = std::conditional_t<G::space_dim == 2, SegmentBeam, SpatialSegmentBeam>;
  return std::make_unique<Chain>(name, std::move(nodes), sections, damping, spec);
}

template <class G>
std::unique_ptr<Body<G>> make(const std::string& name, const BeamSpec& beam, const Space<G>& space,
                              Formalism formalism, const std::vector<int>& held) {
  std::vector<G> nodes;
  for (const SE3& H : beam.nodes) nodes.push_back(space.reduce(H, space.alignment(H)));
  std::vector<SectionLaw> laws;
  for (const Section& section : beam.sections) laws.push_back(section_law(section, beam.material));
  const std::vector<ElementSection<G>> sections = reduce_laws(beam, laws, space);
  const BeamModel as = model_of(beam, formalism);
  if (beam.order == 4) {
    refuse_order_4(name, beam, formalism);
    return std::make_unique<FourthOrderBeam<G>>(name, std::move(nodes), sections, beam.damping);
  }
  if (as == BeamModel::Rigid || as == BeamModel::Modal) {
    auto linear = std::make_unique<Beam<G>>(name, std::move(nodes), sections, beam.damping);
    if (as == BeamModel::Rigid) return std::make_unique<Rigid<G>>(name, std::move(linear));
    return std::make_unique<ModalBody<G>>(std::move(linear), held, beam.modes);
  }
  if (as == BeamModel::Segments)
    return make_segments<G>(name, std::move(nodes), sections, beam.damping, beam.segment);
  if (formalism == Formalism::R3SO3 || formalism == Formalism::Classical)
    return std::make_unique<ReissnerBeam<G>>(name, std::move(nodes), sections, beam.damping);
  return std::make_unique<Beam<G>>(name, std::move(nodes), sections, beam.damping);
}

template <class G>
std::unique_ptr<Body<G>> make(const std::string& name, const RigidSpec& rigid,
                              const Space<G>& space, Formalism, const std::vector<int>&) {
  const SE3 align = space.alignment(rigid.frame);
  return std::make_unique<Rigid<G>>(name, space.reduce(rigid.frame, align),
                                    space.reduce_law(generalized_inertia(rigid), align));
}

/// A meshed part, or one of matrices, in a floating frame.
template <class G>
std::unique_ptr<SolidBody<G>> make_floating(const std::string& name, const SolidSpec& solid,
                                            std::vector<G> ports, const Eigen::Matrix3d& turn) {
  if (solid.model->coupled_mass())
    return std::make_unique<CoupledMassBody<G>>(name, solid, std::move(ports), turn);
  return std::make_unique<SolidBody<G>>(name, solid, std::move(ports), turn);
}

template <class G>
std::unique_ptr<Body<G>> make(const std::string& name, const SolidSpec& solid,
                              const Space<G>& space, Formalism formalism, const std::vector<int>&) {
  if (solid.mesh().dim != G::space_dim)
    throw std::invalid_argument("the mesh of '" + name + "' has " +
                                std::to_string(solid.mesh().dim) + " dimensions, its mechanism " +
                                std::to_string(G::space_dim));
  const SE3 align = space.alignment(solid.frame);
  std::vector<G> ports;
  for (size_t k = 0; k < solid.interfaces().size(); ++k)
    ports.push_back(space.reduce(solid.port(static_cast<int>(k)), align));
  if (formalism != Formalism::Rigid && solid.as == SolidMotion::Continuum)
    return std::make_unique<ContinuumBody<G>>(name, solid, ports, align.R);
  if (formalism != Formalism::Rigid && (solid.modes > 0 || ports.size() > 1))
    return make_floating<G>(name, solid, std::move(ports), align.R);
  SolidSpec plain = solid;
  plain.modes = 0;
  return std::make_unique<Rigid<G>>(name, std::shared_ptr<SolidBody<G>>(make_floating<G>(
                                              name, plain, std::move(ports), align.R)));
}

}  // namespace

template <FrameGroup G>
std::unique_ptr<Body<G>> build_body(const BodySpec& spec, const Space<G>& space,
                                    Formalism formalism, const std::vector<int>& held) {
  return std::visit(
      [&](const auto& kind) { return make<G>(spec.name, kind, space, formalism, held); },
      spec.kind);
}

template std::unique_ptr<Body<SE2>> build_body(const BodySpec&, const Space<SE2>&, Formalism,
                                               const std::vector<int>&);
template std::unique_ptr<Body<SE3>> build_body(const BodySpec&, const Space<SE3>&, Formalism,
                                               const std::vector<int>&);

}  // namespace liesl
