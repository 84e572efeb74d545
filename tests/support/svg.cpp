// SPDX-License-Identifier: MIT
#include "tests/support/svg.h"

#include <algorithm>
#include <regex>
#include <set>
#include <vector>

namespace bulletnav::tests {
namespace {

std::string TagProblem(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find_first_of("<>", at + 1);
    if (end == std::string::npos || svg[end] == '<') return "a < that begins no tag";
    const std::string tag = svg.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "a quote without end";
    if (tag.ends_with('/') || tag.ends_with('?')) continue;
    if (name[0] != '/') {
      if (open.empty() && name != "svg") return "begins with <" + name + ">";
      open.push_back(name);
      continue;
    }
    if (open.empty() || open.back() != name.substr(1)) return "<" + name + "> ends nothing";
    open.pop_back();
  }
  return open.empty() ? "" : "<" + open.back() + "> has no end";
}

std::set<std::string> Names(const std::string& svg, const std::string& pattern) {
  std::set<std::string> names;
  const std::regex name(pattern);
  for (std::sregex_iterator found(svg.begin(), svg.end(), name), end; found != end; ++found) {
    if (!names.insert((*found)[1]).second) names.insert("twice: " + (*found)[1].str());
  }
  return names;
}

}  // namespace

std::string SvgProblem(const std::string& svg) {
  const std::string problem = TagProblem(svg);
  if (!problem.empty()) return problem;
  const std::set<std::string> ids = Names(svg, "\\bid=\"([^\"]*)\"");
  for (const std::string& id : ids) {
    if (id.starts_with("twice: ")) return id;
  }
  for (const std::string& reference : Names(svg, "(?:url\\(|href=\")#([^\")]*)")) {
    if (!reference.starts_with("twice: ") && ids.count(reference) == 0) {
      return "no part is called " + reference;
    }
  }
  return "";
}

}  // namespace bulletnav::tests
