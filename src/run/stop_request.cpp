#include "run/stop_request.h"

#include <array>
#include <csignal>
#include <ctime>

namespace repose {
namespace {

constexpr std::array signals = {SIGTERM, SIGINT, SIGUSR1};

// All that a handler may touch: the first signal, 0 before, and when it came.
volatile std::sig_atomic_t first_signal = 0;
volatile double first_time = 0.0;

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

extern "C" void note_signal(int signal) {
  constexpr double patience = 0.5;
  if (first_signal == 0) {
    first_time = now();
    first_signal = signal;
  } else if (now() - first_time > patience) {
    std::signal(signal, SIG_DFL);
    raise(signal);  // it ends the process when this handler returns
  }
}

void set_handlers(void (*handler)(int)) {
  for (const int signal : signals) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

const char* name_of(int signal) { return signal == SIGTERM ? "SIGTERM" : signal == SIGINT ? "SIGINT" : "SIGUSR1"; }

}  // namespace

StopRequest::StopRequest() {
  first_signal = 0;
  set_handlers(note_signal);
}

StopRequest::~StopRequest() { set_handlers(SIG_DFL); }

std::optional<std::string> StopRequest::reason(double needed) const {
  if (first_signal != 0) return name_of(first_signal);
  if (time_limit_ && seconds_since(start_) + needed > *time_limit_) return "the time limit";
  return {};
}

}  // namespace repose
