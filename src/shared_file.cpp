#include "shared_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "output/agreement.h"

namespace repose {

std::string read_whole_file(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw FileError(path + ": is a directory, a file was expected");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::stringstream buffer;
  if (file) buffer << file.rdbuf();
  if (!file) throw FileError(path + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
  return buffer.str();
}

std::string read_shared_file(const Communicator& comm, const std::string& path) {
  std::string text;
  agree_after_root(comm, [&] { text = read_whole_file(path); });
  comm.broadcast(text);
  return text;
}

}  // namespace repose
