#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace repose::test {

/// The message of the DeckError that `work` throws, or "no error".
template <class Work>
std::string deck_error(Work&& work) {
  try {
    std::forward<Work>(work)();
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace repose::test
