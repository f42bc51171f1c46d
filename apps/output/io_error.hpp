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
  /// What the system says: of HDF5's report the part in quotes after "error message".
  static std::string plain(const std::string& reason) {
    constexpr const char *kQuote = "error message = '", *kFull = "No space left on device";
    if (reason.find(kFull) != std::string::npos)
      return std::string("the disk is full (") + kFull + "); make room or choose another folder";
    const auto quote = reason.find(kQuote);
    if (quote == std::string::npos) return reason;
    const auto begin = quote + std::char_traits<char>::length(kQuote);
    return reason.substr(begin, reason.find('\'', begin) - begin);
  }

  std::filesystem::path path_;
  std::string reason_;
};

/// Of what only a build with optimisation can do.
inline IoError without_optimisation(const std::string& what, const std::filesystem::path& path) {
  return {what, path,
          "this build has no optimisation; configure with -DLIESL_OPTIM=ON (needs Ipopt and "
          "NLopt)"};
}

}  // namespace liesl::output
