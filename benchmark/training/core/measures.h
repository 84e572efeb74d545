// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/check.h"

namespace bulletnav::bench {

/// Named numbers that say how well a model does.
class Measures {
 public:
  struct Item {
    std::string name;
    double value = 0.0;
  };

  Measures() = default;
  /// Of a struct that lists its numbers in Visit.
  template <class T>
  static Measures Of(T values) {
    Measures measures;
    values.Visit(measures);
    return measures;
  }
  void operator()(std::string_view name, double value) {
    items_.push_back({std::string(name), value});
  }

  const std::vector<Item>& items() const { return items_; }
  /// Expects: a name that is there (checked).
  double at(std::string_view name) const {
    const auto found = std::find_if(items_.begin(), items_.end(), [&](const Item& item) {
      return item.name == name;
    });
    BULLETNAV_CHECK(found != items_.end());
    return found->value;
  }

 private:
  std::vector<Item> items_;
};

}  // namespace bulletnav::bench
