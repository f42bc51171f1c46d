#include "apps/input/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace liesl {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& file, std::string what, std::string expected,
                         std::string hint = "") {
  throw InputError({{file, 0, 0, std::move(what), std::move(expected), std::move(hint)}});
}

/// @throws InputError unless the path is a regular file of a sensible size
void check_file(const fs::path& path, const std::string& expected) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(file, "there is no such file", expected);
  if (error) refuse(file, fmt::format("cannot be read: {}", error.message()), expected);
  if (fs::is_directory(status)) refuse(file, "is a directory", expected, "name a file in it");
  if (!fs::is_regular_file(status)) refuse(file, "is not a regular file", expected);
  const auto size = fs::file_size(path, error);
  if (error) refuse(file, fmt::format("cannot be read: {}", error.message()), expected);
  if (size > kLargestFile)
    refuse(file, fmt::format("is huge ({} MiB)", size >> 20),
           fmt::format("at most {} MiB", kLargestFile >> 20), "is it " + expected + "?");
}

}  // namespace

std::string load_text(const fs::path& path, const std::string& expected) {
  check_file(path, expected);
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream.is_open() || stream.bad())
    refuse(path.string(), "cannot be read", "a readable file", "check its permissions");
  return text.str();
}

Document load_document(const fs::path& path) {
  return parse_document(load_text(path, "a scene or study in TOML"), path.string());
}

namespace {

/// Line (from 1) with a key of more than `parts` dotted parts, 0 if there is none. The parser is
/// recursive and would run out of stack.
int line_of_endless_key(const std::string& text, int parts) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string key = line.substr(0, line.find('='));
    if (key.find(',') == std::string::npos && std::count(key.begin(), key.end(), '.') > parts)
      return number;
  }
  return 0;
}

}  // namespace

Document parse_document(std::string text, std::string file) {
  Document document{std::move(file), std::move(text), {}};
  const bool binary = document.text.find('\0') != std::string::npos;
  if (binary) refuse(document.file, "not TOML: the file is binary", "a scene or study in TOML");
  constexpr int kMostParts = 100;
  if (const int line = line_of_endless_key(document.text, kMostParts); line > 0)
    throw InputError({{document.file, line, 1, "not TOML for liesl: a key of very many parts",
                       fmt::format("at most {} parts between dots", kMostParts), ""}});
  try {
    document.root = toml::parse(document.text, document.file);
  } catch (const toml::parse_error& error) {
    const std::string what(error.description());
    const bool twice = what.find("redefine") != std::string::npos;
    const auto place = error.source().begin;
    throw InputError({{document.file, static_cast<int>(place.line), static_cast<int>(place.column),
                       (twice ? "duplicate name: " : "not TOML: ") + what, "TOML 1.0",
                       twice ? "give every key and every table once" : ""}});
  }
  if (document.root.empty()) refuse(document.file, "the file is empty", "a scene or study in TOML");
  return document;
}

}  // namespace liesl
