#include "verification/baseline/baseline_ledger.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "verification/tests/temporary_directory.hpp"

namespace slosh {
namespace {

const BaselineValue first{0.01, 0.002, -0.05, 0.05}, second{0.012, 0.002, -0.05, 0.05};

class BaselineLedger : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return temporary_.path() / "ledgers" / "a.jsonl"; }

  void approve(const std::vector<BaselineChange>& changes, const std::string& reason) const {
    append_approval({"surges", "2026-01-01T00:00:00Z", "A. Engineer", reason, changes}, file());
  }
  std::string text() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& text) const { std::ofstream(file()) << text; }
  std::string refusal() const {
    try {
      baseline_of(read_ledger(file()));
    } catch (const LedgerError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryDirectory temporary_;
};

TEST_F(BaselineLedger, ThatIsNotThereHoldsNothing) {
  EXPECT_TRUE(read_ledger(file()).empty());
  EXPECT_TRUE(baseline_of({}).empty());
}

TEST_F(BaselineLedger, KeepsEveryApprovalWithWhoWhenAndWhy) {
  approve({{"row", {}, first}}, "first figures");
  approve({{"row", first, second}}, "a better kernel");
  const auto approvals = read_ledger(file());
  ASSERT_EQ(approvals.size(), 2U);
  EXPECT_EQ(approvals[1].campaign, "surges");
  EXPECT_EQ(approvals[1].when_utc, "2026-01-01T00:00:00Z");
  EXPECT_EQ(approvals[1].who, "A. Engineer");
  EXPECT_EQ(approvals[1].reason, "a better kernel");
  ASSERT_EQ(approvals[1].changes.size(), 1U);
  EXPECT_EQ(approvals[1].changes[0].before, first);
  EXPECT_EQ(approvals[1].changes[0].after, second);
  EXPECT_EQ(baseline_of(approvals).at("row"), second);
}

TEST_F(BaselineLedger, OnlyGrows) {
  approve({{"row", {}, first}}, "first figures");
  const std::string before = text();
  approve({{"row", first, second}}, "a better kernel");
  EXPECT_TRUE(text().starts_with(before));
  EXPECT_GT(text().size(), before.size());
}

TEST_F(BaselineLedger, ForgetsARowThatWasTakenOut) {
  approve({{"row", {}, first}, {"other", {}, second}}, "first figures");
  approve({{"row", first, {}}}, "the row is gone");
  const Baseline baseline = baseline_of(read_ledger(file()));
  EXPECT_FALSE(baseline.contains("row"));
  EXPECT_EQ(baseline.at("other"), second);
}

TEST_F(BaselineLedger, FindsANumberThatWasAlteredLater) {
  approve({{"row", {}, first}}, "first figures");
  approve({{"row", first, second}}, "a better kernel");
  std::string altered = text();
  altered.replace(altered.find("0.01,"), 5, "0.02,");
  write(altered);
  EXPECT_NE(refusal().find("a.jsonl:2: the lines before it are not those"), std::string::npos)
      << refusal();
}

TEST_F(BaselineLedger, FindsALineThatWasTakenOut) {
  approve({{"row", {}, first}}, "first figures");
  approve({{"row", first, second}}, "a better kernel");
  write(text().substr(text().find('\n') + 1));
  EXPECT_NE(refusal().find("a.jsonl:1: the lines before it"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, FindsALineThatWasCutOff) {
  approve({{"row", {}, first}}, "first figures");
  write(text().substr(0, text().size() / 2));
  EXPECT_NE(refusal().find("cut off"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, RefusesWhatIsNoApproval) {
  approve({{"row", {}, first}}, "first figures");
  write("{}\n");
  EXPECT_NE(refusal().find("a.jsonl:1: not an approval"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, RefusesAChangeOfWhatDidNotStand) {
  approve({{"row", {}, first}}, "first figures");
  approve({{"row", second, first}}, "of something else");
  EXPECT_NE(refusal().find("row: the old value is not the one that stood"), std::string::npos)
      << refusal();
}

}  // namespace
}  // namespace slosh
