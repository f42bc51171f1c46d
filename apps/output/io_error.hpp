#pragma once
/// @file
/// The one exception of everything that touches files. The program ends with code 3 on it.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace liesl::output {

/// Message: "cannot <what> '<path>': <reason>".
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& what, std::filesystem::path path, const std::string& reason)
      : std::runtime_error("cannot " + what + " '" + path.string() + "': " + reason),
        path_(std::move(path)),
        reason_(reason) {}
  const std::filesystem::path& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  std::filesystem::path path_;
  std::string reason_;
};

}  // namespace liesl::output
