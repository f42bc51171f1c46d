#pragma once
/// @file
/// Texts of files in messages.

#include <string>
#include <string_view>

namespace liesl {

/// Control characters but line ends and tabs as "\x00": a NUL would end a message, an escape
/// sequence would be obeyed by the terminal.
inline std::string printable(std::string_view text) {
  constexpr char kDelete = 0x7f;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool control = (code < ' ' && c != '\n' && c != '\t') || c == kDelete;
    out +=
        control ? std::string("\\x") + kDigits[code / 16] + kDigits[code % 16] : std::string(1, c);
  }
  return out;
}

}  // namespace liesl
