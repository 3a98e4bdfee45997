#include "verification/baseline/baseline_ledger.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <future>
#include <sstream>

#include "verification/files/content_hash.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::baseline_ledger_test {
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

// As Git checks it out where core.autocrlf is set.
TEST_F(BaselineLedger, MayHaveTheLineEndsOfAnotherSystem) {
  approve({{"row", {}, first}}, "first figures");
  const std::string before = text();
  std::string other = before;
  other.insert(other.size() - 1, "\r");
  write(other);
  EXPECT_EQ(refusal(), "");
  approve({{"row", first, second}}, "a better kernel");
  EXPECT_TRUE(text().starts_with(before));
  EXPECT_EQ(baseline_of(read_ledger(file())).at("row"), second);
}

TEST_F(BaselineLedger, TakesTextsInUtf8Alone) {
  EXPECT_THROW(approve({{"row", {}, first}}, "\xe4"), LedgerError);
  EXPECT_TRUE(read_ledger(file()).empty());
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
  EXPECT_NE(refusal().find("a.jsonl:2: the lines before it have changed"), std::string::npos)
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

TEST_F(BaselineLedger, FindsAForgedLastLine) {
  approve({{"row", {}, first}}, "first figures");
  approve({{"row", first, second}}, "a better kernel");
  std::string forged = text();
  forged.replace(forged.rfind("0.05}"), 5, "0.50}");  // a loosened tolerance
  write(forged);
  EXPECT_NE(refusal().find("its head"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("altered, added or removed"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, FindsThatTheLastLineWasTakenOut) {
  approve({{"row", {}, first}}, "first figures");
  const std::string before = text();
  approve({{"row", first, second}}, "a better kernel");
  write(before);
  EXPECT_NE(refusal().find("holds 1 approvals"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("records 2"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, FindsALineAddedByHand) {
  approve({{"row", {}, first}}, "first figures");
  const std::string head_before = read_bytes(head_of(file()));
  approve({{"row", first, second}}, "by hand");
  std::ofstream(head_of(file())) << head_before;
  EXPECT_NE(refusal().find("records 1"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, FindsLinesInAnotherOrder) {
  approve({{"row", {}, first}}, "first figures");
  const std::string one = text();
  approve({{"other", {}, second}}, "another row");
  write(text().substr(one.size()) + one);
  EXPECT_NE(refusal().find("a.jsonl:1: the lines before it"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, IsMissedWhereItsHeadIsThere) {
  approve({{"row", {}, first}}, "first figures");
  std::filesystem::remove(file());
  EXPECT_NE(refusal().find("holds 0 approvals"), std::string::npos) << refusal();
}

TEST_F(BaselineLedger, MissesItsHead) {
  approve({{"row", {}, first}}, "first figures");
  std::filesystem::remove(head_of(file()));
  EXPECT_NE(refusal().find("does not exist"), std::string::npos) << refusal();
  EXPECT_THROW(approve({{"row", first, second}}, "after"), LedgerError);
}

TEST_F(BaselineLedger, RefusesANewApprovalOfWhatDidNotStandAndStaysAsItWas) {
  approve({{"row", {}, first}}, "first figures");
  const std::string before = text();
  EXPECT_THROW(approve({{"row", {}, second}}, "of something else"), LedgerError);
  EXPECT_EQ(text(), before);
  EXPECT_EQ(baseline_of(read_ledger(file())).at("row"), first);
}

TEST_F(BaselineLedger, KeepsSixApprovalsAtOnceOrRefusesThem) {
  std::vector<std::future<void>> approvals;
  for (int i = 0; i < 6; ++i)
    approvals.push_back(std::async(std::launch::async, [this, i] {
      approve({{"row " + std::to_string(i), {}, first}}, "one of six");
    }));
  for (std::future<void>& one : approvals) one.get();
  EXPECT_EQ(read_ledger(file()).size(), 6U);
  EXPECT_EQ(baseline_of(read_ledger(file())).size(), 6U);
  std::atomic<int> refused{0};
  std::vector<std::future<void>> of_one_row;
  for (int i = 0; i < 6; ++i)
    of_one_row.push_back(std::async(std::launch::async, [this, &refused] {
      try {
        approve({{"row 0", first, second}}, "the same six times");
      } catch (const LedgerError&) {
        ++refused;
      }
    }));
  for (std::future<void>& one : of_one_row) one.get();
  EXPECT_EQ(refused, 5);
  EXPECT_EQ(read_ledger(file()).size(), 7U);
}

TEST_F(BaselineLedger, RefusesChangesThatDoNotFollowFromOneAnother) {
  const Approval of_something_else{
      "surges", "2026-01-01T00:00:00Z", "A. Engineer", "none", {{"row", second, first}}};
  try {
    baseline_of({of_something_else});
    FAIL();
  } catch (const LedgerError& error) {
    EXPECT_NE(std::string(error.what()).find("row: the old value differs from the baseline"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace slosh::baseline_ledger_test
