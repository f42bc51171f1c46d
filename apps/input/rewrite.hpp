#pragma once
/// @file
/// Changes to the text of a scene, where comments and layout stay as they are.

#include <string>
#include <vector>

namespace liesl {

/// A scene's text, without its line of a schema, with changes "key.path=value" written into it:
/// values that are there are replaced in their place, others are put behind the last value of their
/// table. The result parses to the same tables as the text with `apply_overrides`; where that
/// cannot be had in place, the whole file is written anew, without comments.
/// @throws InputError if the text is not TOML or a change is none of the scene
std::string rewrite_scene(const std::string& text, const std::vector<std::string>& changes);

/// The text without the line `#:schema PATH` on top, by which editors find the JSON Schema: the
/// path is that of the file's own folder.
std::string without_schema_line(const std::string& text);

}  // namespace liesl
