#pragma once
/// @file
/// A scene with half and twice its mesh, and its step.

#include <optional>
#include <string>
#include <vector>

#include "apps/lean/setting.hpp"
#include "apps/tasks/part_grids.hpp"

namespace liesl {

constexpr double kStepOrder = 2;      ///< of the integrator
constexpr int kMostElements = 10000;  ///< of a beam

/// A scene as text, with what changes it.
struct VerifiedScene {
  std::string text, file;
  std::vector<std::string> overrides;
  /// Instead of those of the text: responses on its mesh, which move with it where it is refined.
  std::vector<ResponseSpec> responses = {};
};

/// What changes a scene to them, and the scenes: beams by elements, parts by the cells of their
/// grids, motions by steps.
class FinerScenes {
 public:
  using Changes = std::vector<std::string>;  ///< "key.path=value"

  /// @param scene as read from the source  @param space "planar" or "spatial"; empty: as it says
  /// @param warnings takes what has no finer mesh  @pre all outlive this
  FinerScenes(const VerifiedScene& source, const Scene& scene, const std::string& space,
              std::vector<std::string>& warnings);

  /// 2 or 0.5 times the elements of beams and, in each direction, the cells of parts; empty: there
  /// is no other mesh.
  Changes with_mesh(double factor) const;
  /// 2 or 0.5 times the steps, with iterations that leave no error; empty: there are no steps.
  Changes with_steps(double factor) const;
  /// Can every mesh that is refined have exactly half of its elements?
  bool mesh_halves() const;
  bool steps_halve() const { return given_.steps > 0 && given_.steps % 2 == 0; }

  /// That of the error by the mesh.
  int mesh_order() const { return mesh_order_; }
  /// Beams and parts that have no finer mesh: "part rod".
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// Are the iterations of the scene those of `with_steps`?
  bool iterated() const { return iterated_.empty(); }

  /// @throws InputError for what the scene does not allow
  Scene read(const Changes& more) const;

 private:
  std::optional<Scene> readable(const Changes& changes) const;
  /// Has it every place of the scene on twice its elements, too?
  bool keeps_places(const Scene& scene, const BeamSetting& beam) const;
  void keep_named_places(const Scene& scene);
  void leave_out(const std::string& what, const std::string& why);
  void find_grids(const Scene& scene);
  void find_order(const Scene& scene);
  Setting beams(double factor) const;

  const VerifiedScene& source_;
  Changes overrides_;
  const Mechanism& mechanism_;
  std::vector<std::string>& warnings_;
  Setting given_;
  std::vector<PartGrid> grids_;  ///< that are refined
  std::vector<std::string> left_out_;
  Changes iterated_;                       ///< what runs of other steps change besides
  std::optional<double> error_tolerance_;  ///< of an adapted step
  int mesh_order_ = 4;
};

}  // namespace liesl
