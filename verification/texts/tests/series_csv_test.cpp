#include "verification/texts/series_csv.hpp"

#include <gtest/gtest.h>

namespace slosh::series_csv_test {
namespace {

RunResult result_of(const std::vector<TimeSeries>& series) {
  RunResult result{};
  result.series = series;
  return result;
}

TEST(SeriesCsv, HasAColumnOfEachSeriesWithItsUnit) {
  EXPECT_EQ(series_csv(result_of({{"elevation@right", "m", {0, 0.1}, {0, 1.0 / 3}},
                                  {"force_x", "N/m", {0, 0.1}, {-1e-7, 2}}})),
            "time [s],elevation@right [m],force_x [N/m]\n"
            "0,0,-1e-07\n"
            "0.1,0.3333333333333333,2\n");
}

TEST(SeriesCsv, LeavesACellEmptyWhereASeriesHasNoValue) {
  EXPECT_EQ(series_csv(result_of({{"a", "m", {0, 2}, {1, 2}}, {"b", "Pa", {1, 2, 3}, {3, 4, 5}}})),
            "time [s],a [m],b [Pa]\n"
            "0,1,\n"
            "1,,3\n"
            "2,2,4\n"
            "3,,5\n");
}

TEST(SeriesCsv, RefusesTimesThatDoNotIncrease) {
  EXPECT_THROW(series_csv(result_of({{"a", "m", {0, 2, 2}, {1, 2, 3}}})), ResultError);
}

}  // namespace
}  // namespace slosh::series_csv_test
