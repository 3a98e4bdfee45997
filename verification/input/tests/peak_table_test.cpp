// Tables of peaks: read in pascal, or refused with their line. The published one is checked by its
// statistics.

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "verification/input/tables/time_table.hpp"
#include "verification/series/distribution.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/published_records.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::peak_table_test {
namespace {

const std::string head = "Pressure in mBar\t\t\t\n1st peak\t2nd peak\t3th peak\t4th peak\n";

PeakTable table_of(const std::string& text) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "peaks.txt";
  std::ofstream(file) << text;
  return read_peak_table(file);
}

// Returns the message without the table's directory.
std::string complaint_about(const std::string& text) {
  const std::string message = message_of<CaseFileError>([&] { table_of(text); });
  return message.empty() ? "" : message.substr(message.find("peaks.txt"));
}

TEST(PeakTable, IsReadInPascalByImpact) {
  for (const std::string& text : {head + "34.149\t36.254\t73.627\t55.853\n40\t48.5\t34\t93.2\n",
                                  head + "34.149 36.254  73.627 55.853\r\n\n 40 48.5 34 93.2 \n"}) {
    const PeakTable table = table_of(text);
    ASSERT_EQ(table.impacts[0].size(), 2U);
    EXPECT_DOUBLE_EQ(table.impacts[0][0], 3414.9);
    EXPECT_DOUBLE_EQ(table.impacts[3][0], 5585.3);
    EXPECT_DOUBLE_EQ(table.impacts[0][1], 4000);
    EXPECT_DOUBLE_EQ(table.impacts[3][1], 9320);
  }
}

TEST(PeakTable, IsRefusedByItsLine) {
  const std::string row = "30\t40\t50\t60\n";
  const std::vector<std::pair<std::string, std::string>> tables{
      {"", "peaks.txt:1: title = : expected a file that can be read and holds a table of peaks"},
      {"Pressure in Pa\n" + row + row,
       "peaks.txt:1: title = Pressure in Pa: expected a title that names the unit, mbar"},
      {"Pressure in mBar\n" + row + row,
       "peaks.txt:2: header = 30\t40\t50\t60: expected the names of the columns"},
      {"Pressure in mBar\n\n" + row + row, "peaks.txt:2: header = : expected"},
      {"Pressure in mBar\n", "peaks.txt:1: header = "},
      {head + row + "30\t40\t50\n",
       "peaks.txt:4: row = 30\t40\t50: expected four numbers, in mbar"},
      {head + row + "30\t40\t50\t60\t70\n", "peaks.txt:4: row = 30\t40\t50\t60\t70: expected"},
      {head + row + "30\t40\tnan\t60\n", "peaks.txt:4: row = 30\t40\tnan\t60: expected"},
      {head + row + "30\t40\tinf\t60\n", "peaks.txt:4: row = "},
      {head + row + "30\t40\t5,0\t60\n", "peaks.txt:4: row = "},
      {head + row + "30\t40\t1e999\t60\n", "peaks.txt:4: row = "},
      {head + row, "peaks.txt:3: rows = 1: expected at least 2"}};
  for (const auto& [text, wanted] : tables) {
    EXPECT_TRUE(begins(complaint_about(text), wanted));
  }
}

TEST(PeakTable, ThatCannotBeReadIsNamed) {
  EXPECT_TRUE(begins(message_of<CaseFileError>([] { read_peak_table("/nowhere/peaks.txt"); }),
                     "/nowhere/peaks.txt:1: title = : expected a file"));
}

TEST(PeakTableOfSpheric10, HasThePublishedMeansAndDeviations) {
  const std::string name = "spheric_test10/Water_4first_peak_lateral_impact_tto_0_85_H93_B1X.txt";
  const auto file = published_record(name);
  if (!file) GTEST_SKIP() << name << record_missing;
  const PeakTable table = read_peak_table(*file);
  const std::vector<double> means{3710, 4816, 4691, 4643}, deviations{732, 1501, 1706, 1323};
  for (std::size_t i = 0; i < 4; ++i) {
    const Distribution peaks("impact " + std::to_string(i + 1), table.impacts[i]);
    EXPECT_EQ(peaks.sorted().size(), 102U);
    // Published to 1 Pa; the fourth mean, 4643 Pa, is 4642.47 Pa.
    EXPECT_NEAR(peaks.mean(), means[i], 0.6) << i;
    EXPECT_NEAR(peaks.standard_deviation(), deviations[i], 0.5) << i;
  }
}

// Every read of a directory fails, as on a disk that breaks down in the middle of a file.
TEST(Tables, ThatCannotBeReadToTheirEndAreNoShorterOnes) {
  const TemporaryDirectory directory;
  for (const std::function<void()>& read : std::vector<std::function<void()>>{
           [&] { read_peak_table(directory.path()); },
           [&] { read_time_table(directory.path(), {"displacement_m"}); },
           [&] {
             read_time_columns(directory.path(), {"t_s", "p_Pa", {"unit", "Pa", "pressure", "Pa"}});
           }})
    EXPECT_TRUE(begins(
        message_of<CaseFileError>(read),
        directory.path().string() + ":1: file = filesystem error: cannot read: Is a directory"));
}

}  // namespace
}  // namespace slosh::peak_table_test
