// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

namespace bulletnav::bench {

/// A table to print: columns in groups under common heads, rows that are ours or the paper's.
struct ResultsTable {
  struct Group {
    std::string head;  // over its columns
    std::vector<std::string> columns;
  };
  struct Row {
    std::string setting;  // "RGB", "RGBD"
    std::string title;
    bool is_paper = false;
    std::vector<std::string> cells;  // one a column; empty where there is no figure
    std::string remark;              // in the last column: episodes, intervals, frames, notes
  };
  std::string caption;
  std::vector<Group> groups;
  std::vector<Row> rows;
  std::string titles = "Model";  // over what rows are of
};

std::string ToMarkdown(const ResultsTable& table);
/// A tabular environment that needs no package.
std::string ToLatex(const ResultsTable& table);

}  // namespace bulletnav::bench
