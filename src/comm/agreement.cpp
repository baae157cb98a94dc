#include "comm/agreement.h"

#include <exception>
#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

void agree_after(const Communicator& comm, const std::function<void()>& work) {
  bool failed = false;
  int code = static_cast<int>(ExitCode::file);
  std::string message;
  try {
    work();
  } catch (const Error& error) {
    failed = true;
    code = static_cast<int>(error.code());
    message = error.what();
  } catch (const std::filesystem::filesystem_error& error) {
    failed = true;
    message = fmt::format("{}: cannot use this path: {}", error.path1().string(), error.code().message());
  } catch (const std::exception& error) {
    failed = true;
    message = error.what();
  }
  const int first_failed = comm.min(failed ? comm.rank() : comm.size());
  if (first_failed == comm.size()) return;
  comm.broadcast(message, first_failed);
  comm.broadcast(code, first_failed);
  if (code == static_cast<int>(ExitCode::file)) throw FileError(message);
  throw Error(static_cast<ExitCode>(code), message);
}

void agree_after_root(const Communicator& comm, const std::function<void()>& work) {
  agree_after(comm, [&] {
    if (comm.is_root()) work();
  });
}

}  // namespace repose
