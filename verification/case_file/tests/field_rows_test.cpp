// Gate rows on pressure fields: what they name, and what they are refused for.
#include <gtest/gtest.h>

#include "verification/case/field_times.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::field_rows_test {
namespace {

const std::string moments = "sample_interval_s = 0.01\nsnapshot_times_s = [1, 2]\n";

std::string row(const std::string& keys) {
  return "[[gate]]\ncandidate = \"coarse\"\nmetric = \"pressure_field_rms\"\n" + keys +
         "\nreason = \"a reason\"\nsource = \"a source\"\n";
}

std::string text_with(const std::string& keys) {
  return edited({"sample_interval_s = 0.01\n", moments}) + row(keys);
}

GateRow read(const std::string& keys) { return read_text(text_with(keys)).gate.back(); }

std::string refusal_of(const std::string& text) try {
  read_text(text);
  return "";
} catch (const CaseFileError& error) {
  return error.what();
}

TEST(FieldRows, AreOfAllMomentsUnlessOneIsNamed) {
  const GateRow whole = read("reference = \"mesh\"\nlimit = 0.2");
  EXPECT_EQ(whole.metric, Metric::pressure_field_rms);
  EXPECT_EQ(whole.reference, "mesh");
  EXPECT_EQ(whole.quantity, pressure_field);
  EXPECT_EQ(whole.mode, "whole");
  EXPECT_EQ(whole.unit, "1");
  EXPECT_EQ(whole.limit, 0.2);
  EXPECT_EQ(read("reference = \"mesh\"\nmode = \"moment_2\"\nlimit = 0.2").mode, "moment_2");
}

TEST(FieldRows, AreRefusedAgainstAnythingButInterFoam) {
  const std::string refusal = refusal_of(text_with("reference = \"theory\"\nlimit = 0.2"));
  EXPECT_NE(refusal.find("an OpenFOAM run other than the candidate"), std::string::npos) << refusal;
}

TEST(FieldRows, AreRefusedOfAMomentThatTheCaseDoesNotHave) {
  const std::string refusal =
      refusal_of(text_with("reference = \"mesh\"\nmode = \"moment_3\"\nlimit = 0.2"));
  EXPECT_NE(refusal.find("moment_2"), std::string::npos) << refusal;
}

TEST(FieldRows, AreRefusedWhereNoFieldIsKept) {
  const std::string refusal = refusal_of(valid_text + row("reference = \"mesh\"\nlimit = 0.2"));
  EXPECT_NE(refusal.find("snapshot_times_s"), std::string::npos) << refusal;
}

TEST(FieldRows, AreRefusedALimitThatAFieldWithoutPressureHolds) {
  const std::string refusal = refusal_of(text_with("reference = \"mesh\"\nlimit = 0.6"));
  EXPECT_NE(refusal.find("without pressure"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace slosh::field_rows_test
