#pragma once
/// @file
/// The one exception of everything that touches files. The program ends with code 3 on it.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace liesl::output {

/// Message: "cannot <what> '<path>': <reason>". A full disk is named as such, whichever library
/// reports it.
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& what, std::filesystem::path path, const std::string& reason)
      : std::runtime_error("cannot " + what + " '" + path.string() + "': " + plain(reason)),
        path_(std::move(path)),
        reason_(plain(reason)) {}
  const std::filesystem::path& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  static std::string plain(const std::string& reason) {
    const bool full = reason.find("No space left on device") != std::string::npos;
    return full ? "the disk is full (" + reason + "); make room or choose another folder" : reason;
  }

  std::filesystem::path path_;
  std::string reason_;
};

}  // namespace liesl::output
