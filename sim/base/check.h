// SPDX-License-Identifier: MIT
#pragma once
#include <sstream>
#include <string>
#include <string_view>

/// CHECK(condition) and CHECK_EQ(a, b) end the program on a broken invariant, always; they are for
/// our own bugs, never for input. DCHECK vanishes from release builds: for pixel loops.
namespace bulletnav::sim::internal {

[[noreturn]] void CheckFailed(std::string_view file, int line, std::string_view condition,
                              const std::string& values);

template <class A, class B>
std::string BothValues(const A& a, const B& b) {
  std::ostringstream out;
  out << " (" << a << " against " << b << ")";
  return out.str();
}

}  // namespace bulletnav::sim::internal

// NOLINTBEGIN(bugprone-macro-parentheses): the operator cannot be parenthesised.
#define CHECK(condition)                                                           \
  do {                                                                             \
    if (!(condition)) {                                                            \
      ::bulletnav::sim::internal::CheckFailed(__FILE__, __LINE__, #condition, {}); \
    }                                                                              \
  } while (false)

#define BULLETNAV_CHECK_OP(a, op, b)                                 \
  do {                                                               \
    const auto& check_a = (a);                                       \
    const auto& check_b = (b);                                       \
    if (!(check_a op check_b)) {                                     \
      ::bulletnav::sim::internal::CheckFailed(                       \
          __FILE__, __LINE__, #a " " #op " " #b,                     \
          ::bulletnav::sim::internal::BothValues(check_a, check_b)); \
    }                                                                \
  } while (false)
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
