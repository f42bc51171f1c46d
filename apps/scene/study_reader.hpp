#pragma once
/// @file
/// What the readers of the parts of a study share.

#include "apps/scene/reader.hpp"
#include "apps/scene/study.hpp"

namespace liesl {

/// State of reading one study on top of its scene.
struct StudyReader {
  toml::table& root;
  const Broken& broken;
  Reader& scene;
  StudySpec& spec;
};

void read_design(StudyReader& reader);
void read_objective(StudyReader& reader);
void read_constraints(StudyReader& reader);
void read_supports(StudyReader& reader);
void read_cycle(StudyReader& reader);

}  // namespace liesl
