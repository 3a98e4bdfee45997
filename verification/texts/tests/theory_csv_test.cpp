#include <gtest/gtest.h>

#include "verification/texts/series_csv.hpp"

namespace slosh::theory_csv_test {
namespace {

CaseTheories theories() {
  CaseTheories theories{};
  theories.result.series = {{"elevation@right/linear", "m", {0, 1}, {0, 0.01}}};
  theories.remarks = {{"linear", "linear flow", "small waves", "none"}};
  return theories;
}

CaseDefinition definition() {
  CaseDefinition definition{};
  definition.name = "surge";
  definition.title = "A surge";
  definition.source = "made for a test,\nin two lines";
  return definition;
}

TEST(TheoryCsv, TellsTheRangeAndTheUncertaintyInCommentsAboveTheTable) {
  EXPECT_EQ(theory_csv(definition(), theories()),
            "# Case surge: A surge\n"
            "# Source: made for a test,\n"
            "# in two lines\n"
            "# linear: linear flow\n"
            "# linear, range: small waves\n"
            "# linear, uncertainty: none\n"
            "time [s],elevation@right/linear [m]\n"
            "0,0\n"
            "1,0.01\n");
}

TEST(TheoryCsv, TellsWhyATheoryIsOutsideItsRange) {
  CaseTheories outside = theories();
  outside.remarks[0].outside = "predicts too high a wave";
  const std::string text = theory_csv(definition(), outside);
  EXPECT_NE(text.find("# linear is outside its range: it predicts too high a wave\n"), text.npos);
}

}  // namespace
}  // namespace slosh::theory_csv_test
