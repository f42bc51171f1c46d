#pragma once
/// @file
/// The choices of a model that cost time and buy accuracy: space, beams, step, tangent.

#include <string>
#include <vector>

#include "apps/scene/scene.hpp"

namespace liesl {

/// How one beam is modelled.
struct BeamSetting {
  std::string name;
  bool rigid = false;  ///< flexible otherwise
  int modes = -1;      ///< >= 0: linear in a floating frame with so many internal modes
  int order = 2;       ///< of its elements
  int elements = 1;
  int multiple = 1;  ///< numbers of elements that keep every place of the scene on a node are its
                     ///< multiples; 0: no other mesh does
  bool segments = false;  ///< a chain of segments
  int numbering = 0;  ///< elements of the mesh by whose numbers the scene names places; 0: of any
};

/// One model of a scene.
struct Setting {
  std::string space = "auto";      ///< as `simulation.space`
  std::vector<BeamSetting> beams;  ///< those that the scene has flexible
  long steps = 0;                  ///< over the whole duration; 0: no dynamics
  double duration = 0;             ///< s
  int record_every = 1;            ///< steps between two records
  std::string tangent = "auto";    ///< as `simulation.tangent`

  double step() const { return steps > 0 ? duration / static_cast<double>(steps) : 0; }  ///< s
  /// The same with `factor` times the elements and steps (halves if 0.5), rounded down to what
  /// the scene allows.
  Setting refined(double factor) const;
};

/// The choices of a scene as it is written. Beams that it has rigid already are left out.
Setting setting_of(const Scene& scene);

/// Places of a beam, 0 at its start and 1 at its end, that the scene names or where its section
/// changes. A mesh that moves one of them is of another mechanism.
std::vector<double> places(const Scene& scene, int body);

/// As `simulation.tangent` names it.
std::string text_of(TangentStrategy tangent);

/// Key changes "key.path=value" that make a setting of the scene as given.
std::vector<std::string> changes(const Setting& wanted, const Setting& given);

}  // namespace liesl
