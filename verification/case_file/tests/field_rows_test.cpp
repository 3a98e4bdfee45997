// Gate rows on pressure fields: what they name, and what they are refused for.
#include <gtest/gtest.h>

#include "verification/case/field_times.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::field_rows_test {
namespace {

const std::string row =
    "[[gate]]\ncandidate = \"coarse\"\nmetric = \"pressure_field_rms\"\nreference = \"mesh\"\n"
    "limit = 0.2\nreason = \"a reason\"\nsource = \"a source\"\n";
const std::string text = with_keys(valid_text, "time.snapshot_times_s = [1, 2]") + row;

TEST(FieldRows, AreOfAllMomentsUnlessOneIsNamed) {
  const GateRow whole = read_text(text).gate.back();
  EXPECT_EQ(whole.metric, Metric::pressure_field_rms);
  EXPECT_EQ(whole.reference, "mesh");
  EXPECT_EQ(whole.quantity, pressure_field);
  EXPECT_EQ(whole.mode, "whole");
  EXPECT_EQ(whole.unit, "1");
  EXPECT_EQ(whole.limit, 0.2);
  EXPECT_EQ(read_text(with_keys(text, "gate.mode = \"moment_2\"")).gate.back().mode, "moment_2");
}

TEST(FieldRows, AreRefusedAgainstOtherSolversOtherMomentsAndWideLimits) {
  expect_refusals(text, R"(
gate.reference = "theory": expected an OpenFOAM run other than the candidate
gate.mode = "moment_3": expected ... moment_2
time.snapshot_times_s is missing -> gate.metric = "pressure_field_rms": expected ... snapshot_times_s
gate.limit = 0.6: expected ... without pressure
)");
}

}  // namespace
}  // namespace slosh::field_rows_test
