#pragma once
/// @file
/// Numbers of a page in few bytes: arrays one behind the other, described in JSON.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace liesl::report {

using Json = nlohmann::ordered_json;

/// Arrays of little-endian numbers, each at a multiple of four bytes. An array is described by
/// {"at": first byte, "n": numbers, "type": "f32" | "i16" | "u32"}; i16 also by "scale", which the
/// numbers are multiplied by.
class Blob {
 public:
  /// 32-bit floats: seven digits.
  Json f32(const std::vector<double>& values);
  /// 16 bits over the largest |value|: 3e-5 of that.
  Json i16(const std::vector<double>& values);
  Json u32(const std::vector<std::uint32_t>& values);

  /// [records, N, C] as C arrays [records, N]; a component that never changes is one number.
  enum class Digits { Five, Seven };
  Json components(const std::vector<double>& values, std::size_t C, Digits digits);

  /// All arrays so far, in base64.
  std::string base64() const;
  std::size_t bytes() const { return bytes_.size(); }

 private:
  Json append(const void* data, std::size_t size, std::size_t count, const char* type);

  std::vector<unsigned char> bytes_;
};

/// Base64 of bytes (RFC 4648).
std::string base64(const unsigned char* data, std::size_t size);

}  // namespace liesl::report
