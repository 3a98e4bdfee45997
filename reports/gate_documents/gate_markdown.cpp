#include <fmt/format.h>

#include <algorithm>

#include "reports/gate_documents/gate_document.hpp"
#include "reports/pages/text_markup.hpp"

namespace slosh::reports {
namespace {

constexpr const char* status_mark = "<!-- slosh gate: exit status ";

int badness(const GateEntry& entry) {
  switch (entry.outcome) {
    case GateOutcomeKind::solver_failed:
      return 5;
    case GateOutcomeKind::violated:
      return 4;
    case GateOutcomeKind::not_compared:
      return 3;
    case GateOutcomeKind::inconclusive:
    case GateOutcomeKind::lost:
      return 2;
    case GateOutcomeKind::pass:
    case GateOutcomeKind::skipped:
      return entry.loosened ? 1 : 0;
  }
  return 0;
}

const char* word(GateOutcomeKind outcome) {
  switch (outcome) {
    case GateOutcomeKind::solver_failed:
      return "**solver failed**";
    case GateOutcomeKind::violated:
      return "**violated**";
    case GateOutcomeKind::not_compared:
      return "**not compared**";
    case GateOutcomeKind::inconclusive:
      return "**inconclusive**";
    case GateOutcomeKind::lost:
      return "**lost**";
    case GateOutcomeKind::pass:
      return "pass";
    case GateOutcomeKind::skipped:
      return "skipped";
  }
  return "";
}

bool is_worth_a_line(const GateEntry& entry) {
  return badness(entry) > 0 || (!entry.moved.empty() && entry.moved != "unmoved");
}

}  // namespace

std::vector<const GateEntry*> worst_first(const GateDocument& document) {
  std::vector<const GateEntry*> order;
  for (const GateEntry& entry : document.entries) order.push_back(&entry);
  std::stable_sort(order.begin(), order.end(), [](const GateEntry* one, const GateEntry* other) {
    return badness(*one) > badness(*other);
  });
  return order;
}

std::string gate_markdown(const GateDocument& document) {
  std::string text =
      fmt::format("## {}\n\n{}\n", markdown_text(document.title), markdown_text(document.verdict));
  for (const auto& [group, doubt] : document.doubts)
    text += fmt::format("\n{}\n", markdown_text(doubt));
  if (!document.basis.empty()) text += fmt::format("\n{}\n", markdown_text(document.basis));
  std::string lines;
  std::size_t passed = 0, skipped = 0;
  for (const GateEntry* entry : worst_first(document)) {
    if (!is_worth_a_line(*entry)) {
      ++(entry->outcome == GateOutcomeKind::skipped ? skipped : passed);
      continue;
    }
    lines += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", word(entry->outcome),
                         markdown_text(entry->kind), markdown_text(entry->group),
                         markdown_text(entry->name), markdown_text(entry->message),
                         markdown_text(entry->uncertainties), markdown_text(entry->moved));
  }
  if (!lines.empty())
    text +=
        "\n| verdict | kind | case | row | result | uncertainties | since the baseline |\n"
        "|---|---|---|---|---|---|---|\n" +
        lines;
  if (passed > 0) text += fmt::format("\nRows that pass and have not changed: {}.\n", passed);
  if (skipped > 0)
    text += fmt::format("\nRows that are not selected, or whose records are not supplied: {}.\n",
                        skipped);
  return text + "\n" + status_comment(document);
}

std::string status_comment(const GateDocument& document) {
  return fmt::format("{}{} -->\n", status_mark, document.exit_status);
}

std::optional<int> exit_status_in(const std::string& text) {
  const std::size_t at = text.rfind(status_mark);
  if (at == text.npos) return std::nullopt;
  return std::atoi(text.c_str() + at + std::strlen(status_mark));
}

}  // namespace slosh::reports
