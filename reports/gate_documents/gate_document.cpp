#include "reports/gate_documents/gate_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>
#include <string_view>

#include "reports/pages/text_markup.hpp"
#include "verification/files/foreign/legible_text.hpp"

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
  return properties;
}

// The element and the type of a row; both are empty for one that passes, the type of a skipped one.
struct Element {
  std::string_view name, type;
};

Element element_of(GateOutcomeKind outcome, const GateDocument& document) {
  switch (outcome) {
    case GateOutcomeKind::violated:
      return {"failure", "violated"};
    case GateOutcomeKind::inconclusive:
      return {document.inconclusive_passes ? "skipped" : "failure", "inconclusive"};
    case GateOutcomeKind::lost:
      return {"failure", "lost"};
    case GateOutcomeKind::not_compared:
      return {"error", "not compared"};
    case GateOutcomeKind::solver_failed:
      return {"error", "solver failed"};
    case GateOutcomeKind::skipped:
      return {"skipped", ""};
    case GateOutcomeKind::pass:
      break;
  }
  return {};
}

Xml case_of(const GateEntry& entry, const Element& element) {
  Xml test;
  test.put("<xmlattr>.classname", legible(entry.group));
  test.put("<xmlattr>.name", legible(entry.name));
  test.put("<xmlattr>.file", legible(entry.file));
  test.put("<xmlattr>.line", entry.line);
  test.add_child("properties", properties_of(entry));
  if (!element.name.empty()) {
    Xml told;
    told.put("<xmlattr>.message", legible(entry.message));
    if (!element.type.empty()) told.put("<xmlattr>.type", std::string(element.type));
    test.add_child(std::string(element.name), told);
  }
  return test;
}

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;

  void add(const Element& element) {
    ++tests;
    failures += element.name == "failure";
    errors += element.name == "error";
    skipped += element.name == "skipped";
  }
  void put_on(Xml& element) const {
    element.put("<xmlattr>.tests", tests);
    element.put("<xmlattr>.failures", failures);
    element.put("<xmlattr>.errors", errors);
    element.put("<xmlattr>.skipped", skipped);
  }
};

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
    for (const GateEntry& entry : document.entries) {
      if (entry.group != group) continue;
      const Element element = element_of(entry.outcome, document);
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
