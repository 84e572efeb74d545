// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <CLI/Validators.hpp>
#include <fmt/core.h>

namespace bulletnav::bench {

/// For an option's number. CLI::Range lets through what is not a number.
inline CLI::Validator NumberFrom(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double number = 0.0;
        const bool is_in =
            CLI::detail::lexical_cast(text, number) && number >= low && number <= high;
        return is_in ? std::string()
                     : fmt::format("expected a number from {} to {}, got '{}'", low, high, text);
      },
      fmt::format("from {} to {}", low, high));
}

}  // namespace bulletnav::bench
