#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>
#include <string_view>

#include "reports/gate_documents/gate_document.hpp"
#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {
namespace {

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
    if (const auto doubt = document.doubts.find(group); doubt != document.doubts.end()) {
      Xml properties;
      add_property(properties, "doubtful", doubt->second);
      suite.add_child("properties", properties);
    }
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
