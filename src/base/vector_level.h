#pragma once

#include <string>
#include <type_traits>

namespace repose {

/// Instruction sets that the hot loops are compiled for. All give the same bits.
enum class VectorLevel { sse2, avx2, avx512 };

/// The best level this processor has.
VectorLevel best_vector_level();
/// "auto", "sse2", "avx2" or "avx512"; throws DeckError for another word or a level the processor lacks.
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
template <class Body>
[[gnu::noinline, gnu::target("avx512f,avx512dq,avx512vl,avx512bw,avx512cd")]] auto run_avx512(const Body& body) {
  return run_lanes<8>(body);
}
#endif

}  // namespace detail

/// Runs `body` compiled for a level that this processor has. Only what is inlined into it uses the level: the body has
/// to be a lambda with REPOSE_INLINE behind its parameters, and so has all that it calls. It may take the number of
/// lanes that suits the level, eight for AVX-512 and four for the others, as an `auto` parameter. Elsewhere than on
/// x86-64 the compiler's own baseline serves every level.
template <class Body>
auto at_level([[maybe_unused]] VectorLevel level, const Body& body) {
#if defined(__x86_64__)
  if (level == VectorLevel::avx512) return detail::run_avx512(body);
  if (level == VectorLevel::avx2) return detail::run_avx2(body);
#endif
  return detail::run_plain(body);
}

#define REPOSE_INLINE __attribute__((always_inline))

}  // namespace repose
