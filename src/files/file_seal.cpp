#include "files/file_seal.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/file_descriptor.h"

namespace repose {
namespace {

constexpr std::string_view seal_start = "repose file of ";

/// All bytes of the seal.
std::string seal_text(std::int64_t bytes, std::uint32_t crc) {
  std::string text =
      fmt::format("{}{} bytes; CRC-32 of those behind the first {}: {:08x}\n", seal_start, bytes, seal_bytes, crc);
  text.resize(seal_bytes, '\0');
  return text;
}

/// What is wrong with a file that starts with `seal`, or nothing.
std::string defect(std::string_view seal, std::int64_t bytes, std::uint32_t crc) {
  if (!seal.starts_with(seal_start)) return "this is no file of repose, or its first bytes are damaged";
  const std::string right = seal_text(bytes, crc);
  if (seal == right) return {};
  const std::string_view length = std::string_view(right).substr(0, right.find(';'));
  if (!seal.starts_with(length)) return fmt::format("its length, {} bytes, is not the one it was written with", bytes);
  return "damaged: its checksum is wrong";
}

std::int64_t size_of(const FileDescriptor& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw_system_error("read", path);
  return status.st_size;
}

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t crc_of(const FileDescriptor& file, std::int64_t begin, std::int64_t end) {
  constexpr std::int64_t most_at_once = 1 << 20;
  uLong crc = 0;
  std::vector<char> bytes;
  for (std::int64_t at = begin; at < end; at += most_at_once) {
    bytes.resize(static_cast<std::size_t>(std::min(most_at_once, end - at)));
    file.read_at(bytes, at);
    crc = crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  }
  return static_cast<std::uint32_t>(crc);
}

struct Content {
  std::int64_t bytes;  ///< with the seal
  std::uint32_t crc;   ///< without it
};

/// Collective. Every rank reads an equal part.
Content content_of(const Communicator& comm, const std::string& opened, const std::string& path) {
  std::int64_t bytes = 0;
  agree_after_root(comm, [&] { bytes = size_of(FileDescriptor(opened, O_RDONLY, path), path); });
  comm.broadcast(bytes);
  const std::int64_t sealed = std::max<std::int64_t>(0, bytes - static_cast<std::int64_t>(seal_bytes));
  const auto begin = [&](std::int64_t rank) {
    return static_cast<std::int64_t>(seal_bytes) + sealed / comm.size() * rank + std::min(rank, sealed % comm.size());
  };
  std::uint32_t crc = 0;
  agree_after(
      comm, [&] { crc = crc_of(FileDescriptor(opened, O_RDONLY, path), begin(comm.rank()), begin(comm.rank() + 1)); });
  const std::vector<std::int64_t> parts = comm.all_gather(static_cast<std::int64_t>(crc));
  uLong all = 0;
  for (int r = 0; r < comm.size(); ++r) {
    all = crc32_combine(all, static_cast<uLong>(parts[static_cast<std::size_t>(r)]), begin(r + 1) - begin(r));
  }
  return {bytes, static_cast<std::uint32_t>(all)};
}

}  // namespace

void seal_file(const Communicator& comm, const std::string& opened, const std::string& path) {
  const Content content = content_of(comm, opened, path);
  agree_after_root(comm, [&] {
    FileDescriptor file(opened, O_WRONLY, path);
    file.write(seal_text(content.bytes, content.crc));
    file.close();
  });
}

void check_seal(const Communicator& comm, const std::string& path) {
  const Content content = content_of(comm, path, path);
  agree_after_root(comm, [&] {
    std::vector<char> seal(std::min<std::size_t>(seal_bytes, static_cast<std::size_t>(content.bytes)));
    FileDescriptor(path, O_RDONLY, path).read_at(seal, 0);
    const std::string wrong = defect({seal.data(), seal.size()}, content.bytes, content.crc);
    if (!wrong.empty()) throw FileError(path + ": " + wrong);
  });
}

void check_seal_if_any(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with(seal_start)) return;
  const std::string_view behind = bytes.substr(std::min(seal_bytes, bytes.size()));
  const std::string wrong = defect(bytes.substr(0, seal_bytes), std::ssize(bytes), crc_of(behind));
  if (!wrong.empty()) throw FileError(path + ": " + wrong);
}

}  // namespace repose
