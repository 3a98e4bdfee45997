#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "reports/model/report_files.hpp"

namespace slosh::reports::file_formats_test {
namespace {

TEST(CsvText, QuotesWhatWouldBreakALine) {
  EXPECT_EQ(csv_line({"a b", "c;d", ""}), "a b,c;d,\n");
  EXPECT_EQ(csv_line({"a,b", "say \"no\"", "two\nlines"}),
            "\"a,b\",\"say \"\"no\"\"\",\"two\nlines\"\n");
}

TEST(CsvText, WritesNumbersThatReadAsTheSame) {
  for (const double value : {0.1, 1.0 / 3, -2.5e-300, 123456789.123456789, 5e-324})
    EXPECT_EQ(std::strtod(csv_number(value).c_str(), nullptr), value);
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(Base64, IsThatOfRfc4648) {
  // Its section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace slosh::reports::file_formats_test
