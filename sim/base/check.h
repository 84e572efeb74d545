// SPDX-License-Identifier: MIT
#pragma once
#include <sstream>
#include <string>
#include <string_view>

#include "sim/base/check_failed.h"

/// BULLETNAV_CHECK(condition) and BULLETNAV_CHECK_EQ(a, b) end the program on a broken invariant,
/// always; they are for our own bugs, never for input. BULLETNAV_DCHECK vanishes from release
/// builds: for pixel loops.
namespace bulletnav::sim::internal {

template <class A, class B>
std::string BothValues(const A& a, const B& b) {
  std::ostringstream out;
  out << " (" << a << " against " << b << ")";
  return out.str();
}

template <class Holds, class A, class B>
void CheckBoth(const Holds& holds, const A& a, const B& b, std::string_view file, int line,
               std::string_view condition) {
  if (!holds(a, b)) CheckFailed(file, line, condition, BothValues(a, b));
}

}  // namespace bulletnav::sim::internal

// NOLINTBEGIN(bugprone-macro-parentheses): the operator cannot be parenthesised.
#define BULLETNAV_CHECK(condition) \
  ((condition) ? void(0)           \
               : ::bulletnav::sim::internal::CheckFailed(__FILE__, __LINE__, #condition, {}))

#define BULLETNAV_CHECK_OP(a, op, b)                 \
  ::bulletnav::sim::internal::CheckBoth(             \
      [](const auto& check_a, const auto& check_b) { \
        return check_a op check_b;                   \
      },                                             \
      a, b, __FILE__, __LINE__, #a " " #op " " #b)
// NOLINTEND(bugprone-macro-parentheses)

#define BULLETNAV_CHECK_EQ(a, b) BULLETNAV_CHECK_OP(a, ==, b)
#define BULLETNAV_CHECK_LT(a, b) BULLETNAV_CHECK_OP(a, <, b)
#define BULLETNAV_CHECK_LE(a, b) BULLETNAV_CHECK_OP(a, <=, b)
#define BULLETNAV_CHECK_GT(a, b) BULLETNAV_CHECK_OP(a, >, b)
#define BULLETNAV_CHECK_GE(a, b) BULLETNAV_CHECK_OP(a, >=, b)

#ifdef NDEBUG
#define BULLETNAV_DCHECK(condition) \
  do {                              \
  } while (false)
#else
#define BULLETNAV_DCHECK(condition) BULLETNAV_CHECK(condition)
#endif
