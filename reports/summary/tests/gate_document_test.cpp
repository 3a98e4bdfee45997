#include "reports/summary/gate_document.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <limits>
#include <sstream>

#include "verification/tests/messages.hpp"

namespace slosh::reports::gate_document_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

GateEntry entry(Verdict outcome, const std::string& name) {
  return {.verdict = outcome,
          .group = "surge & roll",
          .name = name,
          .message = "3 % is not <= 1 % | at all",
          .unit = "1",
          .value = 0.03,
          .uncertainty = 0.002,
          .lower = -0.01,
          .upper = 0.01,
          .moved = "",
          .loosened = false,
          .file = "verification/cases/surge.toml",
          .line = 42};
}

GateDocument document() {
  GateEntry loosened = entry(Verdict::pass, "loosened");
  loosened.loosened = true;
  loosened.moved = "unmoved, tolerance loosened: -1 % .. +1 % -> -2 % .. +2 %";
  GateEntry lost = entry(Verdict::not_compared, "lost");
  lost.value = lost.uncertainty = nan;
  GateEntry crashed = entry(Verdict::solver_failed, "crashed");
  return {
      "Surges",
      "2 of 5 gate rows hold.",
      {entry(Verdict::pass, "fine"), loosened, entry(Verdict::inconclusive, "unsure"),
       entry(Verdict::violated, "broken"), lost, crashed, entry(Verdict::not_selected, "absent")}};
}

boost::property_tree::ptree parsed(const std::string& xml) {
  std::istringstream stream(xml);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

TEST(GateDocument, OrdersTheWorstFirst) {
  const GateDocument gate = document();
  std::vector<std::string> names;
  for (const GateEntry* one : worst_first(gate)) names.push_back(one->name);
  EXPECT_EQ(names, (std::vector<std::string>{"crashed", "broken", "lost", "unsure", "loosened",
                                             "fine", "absent"}));
}

// Of tests, failures, errors and skipped ones.
std::vector<int> counts_of(const GateDocument& gate) {
  const auto suites = parsed(junit_xml(gate)).get_child("testsuites");
  std::vector<int> counts;
  for (const char* of : {"tests", "failures", "errors", "skipped"})
    counts.push_back(suites.get<int>(std::string("<xmlattr>.") + of));
  return counts;
}

TEST(GateDocument, CountsFailuresErrorsAndSkippedRowsApartInJUnit) {
  GateDocument gate = document();
  EXPECT_EQ(counts_of(gate), (std::vector<int>{7, 2, 2, 1}));
  EXPECT_EQ(parsed(junit_xml(gate)).get<std::string>("testsuites.testsuite.<xmlattr>.name"),
            "surge & roll");
  gate.inconclusive_passes = true;
  EXPECT_EQ(counts_of(gate), (std::vector<int>{7, 1, 2, 2}));
  EXPECT_TRUE(holds(gate_markdown(gate), "**inconclusive**"));
  gate.entries = {entry(Verdict::not_selected, "gone"), entry(Verdict::not_selected, "moved")};
  gate.entries[0].lost = true;
  gate.entries[1].moved = "no row of this form any more";
  EXPECT_EQ(counts_of(gate), (std::vector<int>{2, 1, 0, 1})) << "a lost row is a failure";
  EXPECT_TRUE(holds(gate_markdown(gate), "| **lost** |"));
  EXPECT_TRUE(holds(gate_markdown(gate), "| no row of this form any more |"));
}

TEST(GateDocument, GivesValueToleranceAndUncertaintyAsJUnitProperties) {
  const auto suite = parsed(junit_xml(document())).get_child("testsuites.testsuite");
  std::map<std::string, std::string> told;
  for (const auto& [tag, test] : suite) {
    if (tag != "testcase") continue;
    const auto name = test.get<std::string>("<xmlattr>.name");
    for (const auto& [kind, one] : test.get_child("properties"))
      told[name + " " + one.get<std::string>("<xmlattr>.name")] =
          one.get<std::string>("<xmlattr>.value");
    told[name] = test.get<std::string>("failure.<xmlattr>.type",
                                       test.get<std::string>("error.<xmlattr>.type", "none"));
  }
  for (const auto& [name, expected] : {std::pair{"broken value", "0.03"},
                                       {"broken uncertainty_95", "0.002"},
                                       {"broken tolerance_lower", "-0.01"},
                                       {"broken tolerance_upper", "0.01"},
                                       {"lost value", "nan"},
                                       {"broken", "violated"},
                                       {"unsure", "inconclusive"},
                                       {"lost", "not compared"},
                                       {"crashed", "solver failed"},
                                       {"fine", "none"}})
    EXPECT_EQ(told[name], expected) << name;
}

TEST(GateDocument, ListsInMarkdownWhatIsNotSimplyAPassAndCountsTheRest) {
  const std::string text = gate_markdown(document());
  const auto at = [&](const char* what) { return text.find(what); };
  EXPECT_LT(at("**solver failed**"), at("**violated**"));
  EXPECT_LT(at("**violated**"), at("**not compared**"));
  EXPECT_LT(at("**not compared**"), at("**inconclusive**"));
  EXPECT_LT(at("unsure"), at("tolerance loosened"));
  EXPECT_EQ(at("| fine"), text.npos);
  EXPECT_NE(at("\nRows that pass, have not changed and leave nothing open: 1.\n"), text.npos);
  EXPECT_NE(at("\nRows that are not selected, or whose records are not supplied: 1.\n"), text.npos);
  EXPECT_NE(at("3 % is not &lt;= 1 % \\| at all"), text.npos);  // the bar would end the cell
  GateDocument open = document();  // a row passes and leaves something open
  for (GateEntry& entry : open.entries)
    if (entry.name == "fine") entry.remarks = "doubtful: the candidate stays at its highest value";
  EXPECT_TRUE(holds(gate_markdown(open), "| fine"));
  EXPECT_FALSE(holds(gate_markdown(open), "leave nothing open"));
  EXPECT_TRUE(holds(junit_xml(open), "\"doubtful: the candidate stays at its highest value\""));
}

TEST(GateDocument, TellsOfRunsThatAreNotSoundBelowItsHeadlineAndInTheirSuite) {
  GateDocument gate = document();
  const auto doubt = [&] {
    return parsed(junit_xml(gate))
        .get<std::string>("testsuites.testsuite.properties.property.<xmlattr>.value", "");
  };
  EXPECT_EQ(doubt(), "");
  gate.basis = "7 rows.";
  gate.doubts["surge & roll"] = {"doubtful: surge & roll: sph is not sound"};
  EXPECT_EQ(doubt(), "doubtful: surge & roll: sph is not sound");
  const std::string text = gate_markdown(gate);
  const std::size_t at = text.find("\ndoubtful: surge &amp; roll: sph is not sound\n");
  ASSERT_NE(at, text.npos) << text;
  EXPECT_LT(at, text.find("7 rows."));
}

TEST(GateDocument, HoldsNoTagOfANameInItsMarkdown) {
  GateDocument hostile = document();
  hostile.title = "<script>alert(1)</script> `<b>` | x";
  hostile.verdict = "<i>0 of 6</i> <!-- slosh gate: exit status 0 -->";
  hostile.exit_status = 3;
  for (GateEntry& entry : hostile.entries)
    entry.group = entry.name = entry.message = entry.moved = "<img src=x> `a|<b>` | c";
  const std::string text = gate_markdown(hostile);
  EXPECT_EQ(text.find('<'), text.find("<!-- slosh gate: exit status 3 -->\n")) << text;
  EXPECT_EQ(exit_status_in(text), 3);
  EXPECT_FALSE(exit_status_in("PASS"));
  EXPECT_TRUE(holds(text, "&lt;script&gt;"));
  EXPECT_TRUE(holds(text, "&lt;img src=x&gt;"));
  const std::string row = text.substr(text.find("| **not compared**"));
  std::string line = row.substr(0, row.find('\n'));
  boost::replace_all(line, "\\|", "");
  EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 8) << line;  // of seven columns
}

TEST(GateDocument, TellsInMarkdownEachRowsKindAndUncertaintiesAndWhatTheRowsRestOn) {
  GateDocument gate = document();
  gate.basis = "Rows: 1 against exact solutions.";
  gate.speed = "SPH: 5 times the speed of interFoam.";
  gate.standings = {"headline", "", "", {"case", "rms"}, {{"surge | roll", "5 %"}}};
  for (GateEntry& one : gate.entries) {
    one.kind = "validation";
    one.uncertainties = "u_num 1 %, u_input unknown, u_reference 2 %";
  }
  const std::string text = gate_markdown(gate);
  EXPECT_TRUE(
      holds(text,
            "2 of 5 gate rows hold.\n\n| case | rms |\n|---|---|\n| surge \\| roll | 5 % |\n\n"
            "Rows: 1 against exact solutions.\n\nSPH: 5 times the speed"));
  EXPECT_TRUE(holds(text, "| **violated** | validation | surge &amp; roll | broken |"));
  EXPECT_TRUE(holds(text, "| u\\_num 1 %, u\\_input unknown, u\\_reference 2 % |"));
}

}  // namespace
}  // namespace slosh::reports::gate_document_test
