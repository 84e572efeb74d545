// SPDX-License-Identifier: MIT
#include "benchmark/report/results_table.h"

#include <string_view>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

std::string EscapeLatex(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "\\textasciitilde{}";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      case '<':
        escaped += "\\textless{}";
        break;
      case '>':
        escaped += "\\textgreater{}";
        break;
      case '|':
        escaped += "\\textbar{}";
        break;
      default:
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
  }
  return escaped;
}

std::string EscapeMarkdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\|*").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string MarkdownLine(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line.append(" ").append(cell).append(" |");
  return line + "\n";
}

}  // namespace

std::string ToMarkdown(const ResultsTable& table) {
  std::vector<std::string> heads = {"", table.titles};
  std::vector<std::string> rule = {"---", "---"};
  for (const ResultsTable::Group& group : table.groups) {
    for (const std::string& column : group.columns) {
      heads.push_back(fmt::format("{} {}", group.head, column));
      rule.emplace_back("---:");
    }
  }
  heads.emplace_back("This run");
  rule.emplace_back("---");
  std::string text = table.caption + "\n\n" + MarkdownLine(heads) + MarkdownLine(rule);
  for (const ResultsTable::Row& row : table.rows) {
    const std::string mark = row.is_paper ? "*" : "";
    std::vector<std::string> cells = {row.setting,
                                      fmt::format("{0}{1}{0}", mark, EscapeMarkdown(row.title))};
    for (const std::string& cell : row.cells) {
      cells.push_back(cell.empty() ? "" : fmt::format("{0}{1}{0}", mark, cell));
    }
    cells.push_back(EscapeMarkdown(row.remark));
    text += MarkdownLine(cells);
  }
  return text + "\n";
}

std::string ToLatex(const ResultsTable& table) {
  std::string shape = "ll";
  std::string heads = " & ";
  std::string columns = " & " + EscapeLatex(table.titles);
  for (const ResultsTable::Group& group : table.groups) {
    shape += std::string(group.columns.size(), 'r');
    heads += fmt::format(" & \\multicolumn{{{}}}{{c}}{{{}}}", group.columns.size(),
                         EscapeLatex(group.head));
    for (const std::string& column : group.columns) {
      columns.append(" & ").append(EscapeLatex(column));
    }
  }
  std::string text = "% " + table.caption + "\n\\begin{tabular}{" + shape + "l}\n\\hline\n" +
                     heads + " & \\\\\n" + columns + " & \\\\\n\\hline\n";
  for (const ResultsTable::Row& row : table.rows) {
    const auto shown = [&](const std::string& cell) {
      if (cell.empty() || !row.is_paper) return EscapeLatex(cell);
      return "\\emph{" + EscapeLatex(cell) + "}";
    };
    text += EscapeLatex(row.setting) + " & " + shown(row.title);
    for (const std::string& cell : row.cells) text += " & " + shown(cell);
    text += " & " + EscapeLatex(row.remark) + " \\\\\n";
  }
  return text + "\\hline\n\\end{tabular}\n\n";
}

}  // namespace bulletnav::bench
