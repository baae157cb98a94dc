#include "commands/study_request.h"

#include <cstdio>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"

namespace repose {

double seconds_of_time_limit(const std::string& limit) {
  unsigned days = 0;
  unsigned hours = 0;
  unsigned minutes = 0;
  unsigned seconds = 0;
  int end = 0;
  const char* text = limit.c_str();
  const bool plain = limit.find_first_not_of("0123456789:-") == std::string::npos && limit.size() < 16;
  const bool with_days = plain && std::sscanf(text, "%u-%u:%2u:%2u%n", &days, &hours, &minutes, &seconds, &end) == 4;
  if (!with_days) {
    days = 0;
    if (!plain || std::sscanf(text, "%u:%2u:%2u%n", &hours, &minutes, &seconds, &end) != 3) end = -1;
  }
  if (end != static_cast<int>(limit.size()) || minutes > 59 || seconds > 59) {
    throw DeckError(fmt::format("--time-limit {}: HH:MM:SS or D-HH:MM:SS was expected", limit));
  }
  return 86400.0 * days + 3600.0 * hours + 60.0 * minutes + seconds;
}

void StudyRequest::declare(Options& options, const std::string& name, const std::string& meaning) {
  options.argument(name, file, meaning);
  declare_overrides(options, overrides);
  options.option("--output", output, "DIR", "directory of the results", Options::Need::must);
  options.choice("--vector-level", vector_level, {"auto", "sse2", "avx2", "avx512x4", "avx512"},
                 "vector instructions; they change the speed, never the result");
  options.parsed(
      "--time-limit", [this](const std::string& limit) { time_limit = seconds_of_time_limit(limit); }, "HH:MM:SS",
      "stop in time with a checkpoint and exit code 75");
  options.flag("--quiet", quiet, "no progress lines");
}

RunRequest StudyRequest::run_request(const Communicator& world) const {
  VectorLevel level{};
  agree_after(world, [&] { level = vector_level_from(vector_level); });
  return {.deck = file,
          .overrides = overrides,
          .output = output,
          .level = level,
          .log = {.progress = quiet ? nullptr : stdout}};
}

}  // namespace repose
