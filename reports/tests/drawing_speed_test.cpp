#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "reports/tests/sample_report.hpp"
#include "reports/tests/scratch_directory.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {
namespace {

TEST(HeavyReport, IsDrawnInSecondsAndStaysSmall) {
  Report report = sample_report();
  for (int i = 0; i < 25; ++i)
    report.sections[1].figures.push_back(heavy_figure("heavy-" + std::to_string(i)));
  const ScratchDirectory scratch;
  const auto start = std::chrono::steady_clock::now();
  write_report(report, scratch / "report");
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const auto bytes = std::filesystem::file_size(scratch / "report/index.html");
  RecordProperty("seconds", std::to_string(elapsed.count()));
  RecordProperty("page_bytes", std::to_string(bytes));
  EXPECT_LT(elapsed.count(), 10.0);  // s: a report must not be what a campaign waits for
  EXPECT_LT(bytes, 5'000'000u);      // what mail and browsers take without complaint
}

}  // namespace
}  // namespace slosh::reports
