#pragma once

#include <string>
#include <type_traits>

namespace repose {

/// Instruction sets that the hot loops are compiled for, and how many lanes they work on. All give the same bits.
enum class VectorLevel {
  sse2,      ///< four lanes, in pairs of registers
  avx2,      ///< four lanes
  avx512x4,  ///< four lanes: for processors that take registers of 512 bits in two halves (AMD Zen 4)
  avx512     ///< eight lanes
};

/// The fastest level on this processor.
VectorLevel best_vector_level();
/// Whether this processor has the level's instructions.
bool is_available(VectorLevel level);
/// "auto" or the name of a level; throws DeckError for another word or a level the processor lacks.
VectorLevel vector_level_from(const std::string& name);
std::string to_string(VectorLevel level);

namespace detail {

/// A body that takes a parameter gets the number of lanes as an integral constant.
template <int lanes, class Body>
[[gnu::always_inline]] inline auto run_lanes(const Body& body) {
  using Number = std::integral_constant<int, lanes>;
  if constexpr (std::is_invocable_v<const Body&, Number>) {
    return body(Number{});
  } else {
    return body();
  }
}

template <class Body>
[[gnu::noinline]] auto run_plain(const Body& body) {
  return run_lanes<4>(body);
}
#if defined(__x86_64__)
template <class Body>
[[gnu::noinline, gnu::target("avx2")]] auto run_avx2(const Body& body) {
  return run_lanes<4>(body);
}
#define REPOSE_AVX512 gnu::target("avx512f,avx512dq,avx512vl,avx512bw,avx512cd")
template <class Body>
[[gnu::noinline, REPOSE_AVX512]] auto run_x4_avx512(const Body& body) {
  return run_lanes<4>(body);
}
template <class Body>
[[gnu::noinline, REPOSE_AVX512]] auto run_avx512(const Body& body) {
  return run_lanes<8>(body);
}
#undef REPOSE_AVX512
#endif

}  // namespace detail

/// Runs `body` compiled for a level that this processor has. Only what is inlined into it uses the level: the body has
/// to be a lambda with REPOSE_INLINE behind its parameters, and so has all that it calls. It may take the level's
/// number of lanes as an `auto` parameter. Elsewhere than on x86-64 the compiler's own baseline serves every level.
template <class Body>
auto at_level([[maybe_unused]] VectorLevel level, const Body& body) {
#if defined(__x86_64__)
  if (level == VectorLevel::avx512) return detail::run_avx512(body);
  if (level == VectorLevel::avx512x4) return detail::run_x4_avx512(body);
  if (level == VectorLevel::avx2) return detail::run_avx2(body);
#endif
  return detail::run_plain(body);
}

#define REPOSE_INLINE __attribute__((always_inline))

}  // namespace repose
