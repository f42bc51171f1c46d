// The functions of one hash, which need not look for it among all that the library knows.
#define OPENSSL_SUPPRESS_DEPRECATED

#include "apps/output/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/sha.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>

#include "apps/output/io_error.hpp"

namespace liesl::output {
namespace {

[[noreturn]] void fail(const char* what, const std::filesystem::path& path) {
  throw IoError(what, path, std::strerror(errno));
}

constexpr std::string_view kPart = ".part-";

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("write", path);
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int reason = written < 0 ? errno : ENOSPC;
      ::close(file);
      errno = reason;
      fail("write", path);
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::close(file) != 0) fail("write", path);  // network file systems report a full disk here
}

void replace_file(const std::filesystem::path& path, std::string_view content) {
  const auto part =
      path.parent_path() / fmt::format(".{}{}{}", path.filename().string(), kPart, ::getpid());
  try {
    write_file(part, content);
  } catch (const IoError& error) {
    ::unlink(part.c_str());
    throw IoError("write", path, error.reason());
  }
  if (::rename(part.c_str(), path.c_str()) != 0) fail("write", path);
}

int writer_of_part(const std::string& name) {
  const auto at = name.rfind(kPart);
  if (at == std::string::npos || at < 2 || name[0] != '.') return 0;
  int process = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + at + kPart.size(), end, process);
  return error == std::errc{} && rest == end ? process : 0;
}

void remove_parts(const std::filesystem::path& folder) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const int writer = writer_of_part(entry.path().filename().string());
    if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH)
      std::filesystem::remove_all(entry.path(), error);
  }
}

std::string read_file(const std::filesystem::path& path, std::size_t limit) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw IoError("read", path, "is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", path);
  std::string content;
  std::array<char, 65536> block;
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (content.size() > limit) {
      throw IoError("read", path, fmt::format("larger than {} bytes", limit));
    }
  }
  if (file.bad()) fail("read", path);
  return content;
}

std::string sha256(std::string_view bytes) {
  SHA256_CTX context;
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  SHA256_Init(&context);
  SHA256_Update(&context, bytes.data(), bytes.size());
  SHA256_Final(digest.data(), &context);
  std::string hex;
  for (const unsigned char byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace liesl::output
