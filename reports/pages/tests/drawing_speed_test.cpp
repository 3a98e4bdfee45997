#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

#include "reports/drawing/draw_field.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::drawing_speed_test {
namespace {

// Processor time of this process and of the gnuplots that it waited for, in s. The time on the
// clock would depend on what else the machine does.
double processor_time() {
  double seconds = 0.0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& part : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  }
  return seconds;
}

TEST(HeavyReport, IsDrawnInSecondsAndStaysSmall) {
  Report report = sample_report();
  for (int i = 0; i < 25; ++i)
    report.sections[1].figures.push_back(heavy_figure("heavy-" + std::to_string(i)));
  const ScratchDirectory scratch;
  const double before = processor_time();
  write_report(report, scratch / "report", {.threads = 2});
  const double elapsed = processor_time() - before;
  const auto bytes = std::filesystem::file_size(scratch / "report/index.html");
  RecordProperty("processor_seconds", std::to_string(elapsed));
  RecordProperty("page_bytes", std::to_string(bytes));
  EXPECT_LT(elapsed, 10.0);      // s: a report must not be what a campaign waits for
  EXPECT_LT(bytes, 5'000'000u);  // what mail and browsers take without complaint
}

TEST(FieldOfTwelvePanels, IsDrawnInSecondsAndStaysSmall) {
  // The panels of a moment have 24 900, 6 200 and 11 100 places.
  const FieldFigure field = sloshing_field("heavy", 4, 0.0017);
  const ScratchDirectory scratch;
  const double before = processor_time();
  const DrawnField drawn = draw_field(field, scratch.path());
  const double elapsed = processor_time() - before;
  RecordProperty("processor_seconds", std::to_string(elapsed));
  RecordProperty("picture_bytes", std::to_string(drawn.picture.size()));
  EXPECT_LT(elapsed, 10.0);                   // s: the bound of the heavy report
  EXPECT_LT(drawn.picture.size(), 400'000u);  // a third more than measured
}

}  // namespace
}  // namespace slosh::reports::drawing_speed_test
