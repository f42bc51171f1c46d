#include "apps/output/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "apps/output/io_error.hpp"

namespace liesl::output {
namespace {

[[noreturn]] void fail(const char* what, const std::filesystem::path& path) {
  throw IoError(what, path, std::strerror(errno));
}

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
      path.parent_path() / fmt::format(".{}.part-{}", path.filename().string(), ::getpid());
  write_file(part, content);
  if (::rename(part.c_str(), path.c_str()) != 0) fail("write", path);
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
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

}  // namespace liesl::output
