#pragma once

namespace tetsculpt::testing {

/// How many random cases a test tries: all that are `asked` for, a tenth of them under the
/// sanitizers. Those slow every case tenfold, and what they look for is on the paths taken, not in
/// rare values.
template <typename Count>
constexpr Count random_cases(Count asked) {
#if defined(__SANITIZE_ADDRESS__)
  return asked / 10;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
  return asked / 10;
#else
  return asked;
#endif
#else
  return asked;
#endif
}

}  // namespace tetsculpt::testing
