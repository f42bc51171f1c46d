#include "mbs/solids/solid_spec.hpp"

#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {

SE3 SolidSpec::port(int interface) const {
  return frame * SE3(Eigen::Matrix3d::Identity(), interfaces.at(interface).point);
}

SolidModel solid_model(const SolidSpec& s) {
  SolidModel::Options options;
  options.thickness = s.thickness;
  options.law = s.law;
  return {s.mesh, s.material, s.interfaces, options};
}

Fractions solid_fractions(const SolidSpec& s) {
  if (s.outline.features.empty())
    return {Eigen::VectorXd::Ones(s.mesh.cell_count()), FractionGradient(s.mesh.cell_count(), 0)};
  return volume_fractions(s.mesh, *make_shape(s.outline));
}

}  // namespace liesl
