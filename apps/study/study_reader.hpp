#pragma once
/// @file
/// What the readers of the parts of a study share.

#include "apps/scene/reader.hpp"
#include "apps/study/study.hpp"

namespace liesl {

/// State of reading one study on top of its scene.
struct StudyReader {
  toml::table& root;
  const Broken& broken;
  Reader& scene;
  StudySpec& spec;
};

void read_design(StudyReader& reader);
/// The catalogue `values` of an entry of [design], said if they are none, not increasing, or
/// outside the bounds; empty: there are none.
std::vector<double> read_values(StudyReader& reader, const Entry& entry, double lower,
                                double upper);
/// An entry of [design] that moves parameters of an outline.
void read_shape_variable(StudyReader& reader, const Entry& entry);
/// Does an entry of [design] mean a constant of a force or of a rigid body?
bool names_constant(const StudyReader& reader, const toml::table& table);
void read_constant(StudyReader& reader, const Entry& entry);
/// Does it mean a value of the table of a drive, "drive.table.ROW" of a joint, or the `duration` of
/// the `simulation`?
bool names_motion(const StudyReader& reader, const toml::table& table);
void read_motion_variable(StudyReader& reader, const Entry& entry);
/// Drives and loads that a variable duration cannot stretch; scenarios.
void check_motion_variables(StudyReader& reader);
/// Adds a note if a limit on a stress stretches its material so little that MPa may be meant.
/// @param key that is limited @param limit Pa @param E of the material, Pa; 0: it has none
void note_stress_limit(StudyReader& reader, const std::string& key, double limit, double E);
/// Walls, limits, fixed loads and stress norm of meshed parts.
void read_parts_of_study(StudyReader& reader);
/// What only shows when the parts are made: bounds that leave no shape, unknown features.
void check_shapes(StudyReader& reader);
void read_objective(StudyReader& reader);
void read_constraints(StudyReader& reader);
void read_frequencies(StudyReader& reader);
void read_supports(StudyReader& reader);
/// Limits that only the sensitivities of a motion tell, in a study that has none.
void check_images(StudyReader& reader);
void read_cycle(StudyReader& reader);

}  // namespace liesl
