#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "reports/fields/draw_field.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::drawing_speed_test {
namespace {

TEST(HeavyReport, IsDrawnInSecondsAndStaysSmall) {
  Report report = sample_report();
  for (int i = 0; i < 25; ++i)
    report.sections[1].figures.push_back(heavy_figure("heavy-" + std::to_string(i)));
  const ScratchDirectory scratch;
  const auto start = std::chrono::steady_clock::now();
  write_report(report, scratch / "report", {.threads = 2});
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const auto bytes = std::filesystem::file_size(scratch / "report/index.html");
  RecordProperty("seconds", std::to_string(elapsed.count()));
  RecordProperty("page_bytes", std::to_string(bytes));
  EXPECT_LT(elapsed.count(), 10.0);  // s: a report must not be what a campaign waits for
  EXPECT_LT(bytes, 5'000'000u);      // what mail and browsers take without complaint
}

TEST(FieldOfTwelvePanels, IsDrawnInSecondsAndStaysSmall) {
  // The panels of a moment have 24 900, 6 200 and 11 100 places.
  const FieldFigure field = sloshing_field("heavy", 4, 0.0017);
  const ScratchDirectory scratch;
  const auto start = std::chrono::steady_clock::now();
  const DrawnField drawn = draw_field(field, scratch.path());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(elapsed.count()));
  RecordProperty("picture_bytes", std::to_string(drawn.png.size()));
  EXPECT_LT(elapsed.count(), 5.0);        // s: 0.8 of processor time
  EXPECT_LT(drawn.png.size(), 400'000u);  // a third more than measured
}

}  // namespace
}  // namespace slosh::reports::drawing_speed_test
