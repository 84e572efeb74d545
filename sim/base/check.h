// SPDX-License-Identifier: MIT
#pragma once
#include <sstream>
#include <string>
#include <string_view>

#include "sim/base/check_failed.h"

/// CHECK(condition) and CHECK_EQ(a, b) end the program on a broken invariant, always; they are for
/// our own bugs, never for input. DCHECK vanishes from release builds: for pixel loops.
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
#define CHECK(condition) \
  ((condition) ? void(0) \
               : ::bulletnav::sim::internal::CheckFailed(__FILE__, __LINE__, #condition, {}))

#define BULLETNAV_CHECK_OP(a, op, b)                 \
  ::bulletnav::sim::internal::CheckBoth(             \
      [](const auto& check_a, const auto& check_b) { \
        return check_a op check_b;                   \
      },                                             \
      a, b, __FILE__, __LINE__, #a " " #op " " #b)
// NOLINTEND(bugprone-macro-parentheses)

#define CHECK_EQ(a, b) BULLETNAV_CHECK_OP(a, ==, b)
#define CHECK_LT(a, b) BULLETNAV_CHECK_OP(a, <, b)
#define CHECK_LE(a, b) BULLETNAV_CHECK_OP(a, <=, b)
#define CHECK_GT(a, b) BULLETNAV_CHECK_OP(a, >, b)
#define CHECK_GE(a, b) BULLETNAV_CHECK_OP(a, >=, b)

#ifdef NDEBUG
#define DCHECK(condition) \
  do {                    \
  } while (false)
#else
#define DCHECK(condition) CHECK(condition)
#endif
