#pragma once

#include <stdexcept>
#include <string>

namespace repose {

/// Exit codes of the program, one per kind of failure (README).
enum class ExitCode { done = 0, usage = 2, physics = 3, file = 4, stopped = 75 };

/// An error that ends a run: one line that says where, what, and what would be right.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Wrong command line or deck.
class DeckError : public Error {
 public:
  explicit DeckError(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// The physics broke: what, where, remedy.
class PhysicsError : public Error {
 public:
  explicit PhysicsError(const std::string& message) : Error(ExitCode::physics, message) {}
};

/// The run was asked to stop and can go on from a checkpoint: submit it again.
class Stopped : public Error {
 public:
  explicit Stopped(const std::string& message) : Error(ExitCode::stopped, message) {}
};

/// A file cannot be read or written.
class FileError : public Error {
 public:
  explicit FileError(const std::string& message) : Error(ExitCode::file, message) {}
};

}  // namespace repose
