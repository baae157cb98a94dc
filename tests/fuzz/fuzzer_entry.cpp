// What libFuzzer calls.
#include <cstddef>
#include <cstdint>

#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  repose::fuzz::accepts({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
