#include "mbs/solids/solid_spec.hpp"

#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {

const SolidMesh& SolidSpec::mesh() const { return model->mesh(); }
const std::vector<Interface>& SolidSpec::interfaces() const { return model->interfaces(); }

SE3 SolidSpec::port(int interface) const {
  return frame * SE3(Eigen::Matrix3d::Identity(), interfaces().at(interface).point);
}

Fractions solid_fractions(const SolidSpec& s) {
  if (s.outline.features.empty())
    return {Eigen::VectorXd::Ones(s.mesh().cell_count()),
            FractionGradient(s.mesh().cell_count(), 0)};
  return volume_fractions(s.mesh(), *make_shape(s.outline));
}

}  // namespace liesl
