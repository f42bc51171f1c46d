#include "apps/report/page.hpp"

#include <vector>

#include "apps/report/blob.hpp"

namespace liesl::report {
namespace {

/// "sha256-..." as a Content-Security-Policy names a text by its hash.
std::string source_hash(std::string_view hex) {
  std::vector<unsigned char> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(
        static_cast<unsigned char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
  return "'sha256-" + base64(bytes.data(), bytes.size()) + "'";
}

/// JSON that may stand in a script element: no "</script>" and no "<!--" in its texts.
std::string inside_script(const nlohmann::ordered_json& data) {
  const std::string text =
      data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size() + text.size() / 16);
  std::size_t from = 0;
  for (std::size_t at; (at = text.find('<', from)) != std::string::npos; from = at + 1)
    out.append(text, from, at - from).append("\\u003c");
  return out.append(text, from);
}

}  // namespace

std::string page(const nlohmann::ordered_json& data, const std::string& blob) {
  const std::string texts = inside_script(data);
  constexpr std::size_t kRest = 2000;  // of the page
  std::string out;
  out.reserve(kNotices.size() + kScript.size() + kStyle.size() + texts.size() + blob.size() +
              kRest);
  out += "<!doctype html>\n<!--\n";
  out += kNotices;
  out += "-->\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src " +
         source_hash(kScriptHash) + "; style-src " + source_hash(kStyleHash) +
         "; base-uri 'none'; form-action 'none'\">\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  out += "<meta name=\"color-scheme\" content=\"light dark\">\n<title>liesl</title>\n<style>";
  out += kStyle;
  out += "</style>\n</head>\n<body>\n<noscript>This page needs JavaScript.</noscript>\n";
  out += "<script type=\"application/json\" id=\"data\">";
  out += texts;
  out += "</script>\n<script type=\"text/plain\" id=\"blob\">";
  out += blob;
  out += "</script>\n<script>";
  out += kScript;
  out += "</script>\n</body>\n</html>\n";
  return out;
}

}  // namespace liesl::report
