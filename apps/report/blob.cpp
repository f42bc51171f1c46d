#include "apps/report/blob.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace liesl::report {

static_assert(std::endian::native == std::endian::little,
              "arrays are written as they lie in memory");

Json Blob::append(const void* data, std::size_t size, std::size_t count, const char* type) {
  Json array = {{"at", bytes_.size()}, {"n", count}, {"type", type}};
  const auto* first = static_cast<const unsigned char*>(data);
  bytes_.insert(bytes_.end(), first, first + size);
  bytes_.resize((bytes_.size() + 3) / 4 * 4, 0);
  return array;
}

Json Blob::f32(const std::vector<double>& values) {
  const std::vector<float> out(values.begin(), values.end());
  return append(out.data(), out.size() * sizeof(float), out.size(), "f32");
}

Json Blob::i16(const std::vector<double>& values) {
  constexpr double kLargest = 32767;
  double size = 0;
  for (const double x : values) size = std::max(size, std::abs(x));
  const double scale = size > 0 ? size / kLargest : 1;
  std::vector<std::int16_t> out;
  for (const double x : values) out.push_back(static_cast<std::int16_t>(std::lround(x / scale)));
  Json array = append(out.data(), out.size() * sizeof(std::int16_t), out.size(), "i16");
  array["scale"] = scale;
  return array;
}

Json Blob::u32(const std::vector<std::uint32_t>& values) {
  return append(values.data(), values.size() * sizeof(std::uint32_t), values.size(), "u32");
}

Json Blob::components(const std::vector<double>& values, std::size_t C, Digits digits) {
  Json list = Json::array();
  std::vector<double> one(values.size() / C);
  for (std::size_t c = 0; c < C; ++c) {
    for (std::size_t i = 0; i < one.size(); ++i) one[i] = values[C * i + c];
    const bool constant =
        std::all_of(one.begin(), one.end(), [&](double x) { return x == one.front(); });
    if (one.empty() || constant)
      list.push_back(one.empty() ? 0 : one.front());
    else
      list.push_back(digits == Digits::Five ? i16(one) : f32(one));
  }
  return list;
}

std::string Blob::base64() const { return report::base64(bytes_.data(), bytes_.size()); }

std::string base64(const unsigned char* data, std::size_t size) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((size + 2) / 3 * 4, '=');
  char* out = text.data();
  for (std::size_t i = 0; i < size; i += 3, out += 4) {
    const std::size_t left = std::min<std::size_t>(3, size - i);
    std::uint32_t bits = static_cast<std::uint32_t>(data[i]) << 16;
    if (left > 1) bits |= static_cast<std::uint32_t>(data[i + 1]) << 8;
    if (left > 2) bits |= data[i + 2];
    for (std::size_t k = 0; k <= left; ++k) out[k] = kDigits[bits >> (18 - 6 * k) & 63u];
  }
  return text;
}

}  // namespace liesl::report
