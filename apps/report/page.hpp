#pragma once
/// @file
/// The HTML text about the data of a page.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace liesl::report {

/// Program and style of the page, see apps/report/page/README.md.
extern const std::string_view kScript, kStyle, kNotices;
/// Their SHA-256, 64 hexadecimal digits: the script is the most of a page.
extern const std::string_view kScriptHash, kStyleHash;

/// A page that holds all it needs and may load nothing (Content-Security-Policy).
/// @param blob base64 of the arrays that `data` describes
std::string page(const nlohmann::ordered_json& data, const std::string& blob);

}  // namespace liesl::report
