#ifdef LIESL_OPTIM

#include "apps/tasks/final_scene.hpp"

#include "apps/study/design_scene.hpp"

namespace liesl {

std::string final_scene(const OptimizeOutcome& out, const Study& study, std::size_t scenario) {
  std::map<std::string, levelset::ShapeSpec> outlines;
  for (const PartOutcome& part : out.parts) outlines[part.name] = part.outline;
  std::map<std::string, double> values;
  for (const output::DesignFigure& figure : out.summary.design) values[figure.name] = figure.final;
  return design_scene(study, out.mechanism, outlines, values, scenario);
}

}  // namespace liesl

#endif
