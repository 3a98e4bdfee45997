#include "reports/summary/gate_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>
#include <string>

#include "reports/pages/text_markup.hpp"
#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {
namespace {

constexpr const char* status_mark = "<!-- slosh gate: exit status ";

// How documents show an entry: its word, how bad it is, and its element in JUnit.
struct ShownVerdict {
  std::string word;
  int badness;
  std::string element;
};

ShownVerdict shown(const GateEntry& entry) {
  if (entry.lost) return {"lost", 2, "failure"};
  const std::string word = verdict_name(entry.verdict);
  switch (entry.verdict) {
    case Verdict::pass:
      return {word, 0, ""};
    case Verdict::inconclusive:
      return {word, 2, "failure"};
    case Verdict::not_compared:
      return {word, 3, "error"};
    case Verdict::violated:
      return {word, 4, "failure"};
    case Verdict::solver_failed:
      return {word, 5, "error"};
    case Verdict::not_selected:
    case Verdict::not_supplied:
      break;
  }
  return {"skipped", 0, "skipped"};
}

int badness(const GateEntry& entry) {
  return std::max(shown(entry).badness, entry.loosened ? 1 : 0);
}

bool is_worth_a_line(const GateEntry& entry) {
  return badness(entry) > 0 || !entry.remarks.empty() || !entry.moved.empty();
}

using Xml = boost::property_tree::ptree;

void add_property(Xml& properties, const char* name, const std::string& value) {
  Xml property;
  property.put("<xmlattr>.name", name);
  property.put("<xmlattr>.value", legible(value));
  properties.add_child("property", property);
}

std::string number(double value) { return fmt::format("{:.10g}", value); }

Xml properties_of(const GateEntry& entry) {
  Xml properties;
  add_property(properties, "value", number(entry.value));
  add_property(properties, "uncertainty_95", number(entry.uncertainty));
  if (entry.lower) add_property(properties, "tolerance_lower", number(*entry.lower));
  if (entry.upper) add_property(properties, "tolerance_upper", number(*entry.upper));
  add_property(properties, "unit", entry.unit);
  if (!entry.moved.empty()) add_property(properties, "since_baseline", entry.moved);
  if (!entry.remarks.empty()) add_property(properties, "remarks", entry.remarks);
  return properties;
}

// Empty for a row that passes.
std::string element_of(const GateEntry& entry, const GateDocument& document) {
  const bool passes =
      !entry.lost && entry.verdict == Verdict::inconclusive && document.inconclusive_passes;
  return passes ? "skipped" : shown(entry).element;
}

Xml case_of(const GateEntry& entry, const std::string& element) {
  Xml test;
  test.put("<xmlattr>.classname", legible(entry.group));
  test.put("<xmlattr>.name", legible(entry.name));
  test.put("<xmlattr>.file", legible(entry.file));
  test.put("<xmlattr>.line", entry.line);
  test.add_child("properties", properties_of(entry));
  if (!element.empty()) {
    Xml told;
    told.put("<xmlattr>.message", legible(entry.message));
    if (const auto [word, bad, of_verdict] = shown(entry); of_verdict != "skipped")
      told.put("<xmlattr>.type", word);
    test.add_child(element, told);
  }
  return test;
}

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;

  void add(const std::string& element) {
    ++tests;
    failures += element == "failure";
    errors += element == "error";
    skipped += element == "skipped";
  }
  void put_on(Xml& element) const {
    element.put("<xmlattr>.tests", tests);
    element.put("<xmlattr>.failures", failures);
    element.put("<xmlattr>.errors", errors);
    element.put("<xmlattr>.skipped", skipped);
  }
};

std::string standings_markdown(const Table& table) {
  if (table.rows.empty()) return "";
  std::string text = fmt::format("\n| {} |\n|", fmt::join(table.header, " | "));
  for (std::size_t i = 0; i < table.header.size(); ++i) text += "---|";
  text += "\n";
  for (const std::vector<std::string>& row : table.rows) {
    text += "|";
    for (const std::string& cell : row) text += fmt::format(" {} |", markdown_text(cell));
    text += "\n";
  }
  return text;
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
  for (const auto& [group, doubts] : document.doubts)
    for (const std::string& doubt : doubts) text += fmt::format("\n{}\n", markdown_text(doubt));
  text += standings_markdown(document.standings);
  for (const std::string& sentence : {document.basis, document.speed})
    if (!sentence.empty()) text += fmt::format("\n{}\n", markdown_text(sentence));
  std::string lines;
  std::size_t passed = 0, skipped = 0;
  for (const GateEntry* entry : worst_first(document)) {
    if (!is_worth_a_line(*entry)) {
      ++(shown(*entry).element == "skipped" ? skipped : passed);
      continue;
    }
    const auto [word, bad, element] = shown(*entry);
    lines += fmt::format("| {0}{1}{0} | {2} | {3} | {4} | {5} | {6} | {7} |\n", bad > 0 ? "**" : "",
                         word, markdown_text(entry->kind), markdown_text(entry->group),
                         markdown_text(entry->name), markdown_text(entry->message),
                         markdown_text(entry->uncertainties), markdown_text(entry->moved));
  }
  if (!lines.empty())
    text +=
        "\n| verdict | kind | case | row | result | uncertainties | since the baseline |\n"
        "|---|---|---|---|---|---|---|\n" +
        lines;
  if (passed > 0)
    text += fmt::format("\nRows that pass, have not changed and leave nothing open: {}.\n", passed);
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

std::string junit_xml(const GateDocument& document) {
  std::vector<std::string> groups;
  for (const GateEntry& entry : document.entries)
    if (std::find(groups.begin(), groups.end(), entry.group) == groups.end())
      groups.push_back(entry.group);
  Xml root, suites;
  Counts all;
  suites.put("<xmlattr>.name", legible(document.title));
  for (const std::string& group : groups) {
    Xml suite;
    Counts counts;
    suite.put("<xmlattr>.name", legible(group));
    if (const auto found = document.doubts.find(group); found != document.doubts.end()) {
      Xml properties;
      for (const std::string& doubt : found->second) add_property(properties, "doubtful", doubt);
      suite.add_child("properties", properties);
    }
    for (const GateEntry& entry : document.entries) {
      if (entry.group != group) continue;
      const std::string element = element_of(entry, document);
      counts.add(element);
      all.add(element);
      suite.add_child("testcase", case_of(entry, element));
    }
    counts.put_on(suite);
    suites.add_child("testsuite", suite);
  }
  all.put_on(suites);
  root.add_child("testsuites", suites);
  std::ostringstream text;
  boost::property_tree::write_xml(
      text, root, boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return text.str() + status_comment(document);
}

}  // namespace slosh::reports
