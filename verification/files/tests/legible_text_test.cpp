// What a program says is shown as text: it commands no terminal and leaves XML well-formed.
#include "verification/files/foreign/legible_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace slosh::legible_text_test {
namespace {

TEST(Legible, TakesOutWhatCommandsATerminalOrBreaksXml) {
  const std::pair<std::string, std::string> texts[] = {
      {"\x1b[31mred\x1b[0m", "red"},
      {"\x1b[2J\x1b[1;1H\x1b[?25lPASS", "PASS"},
      {"\x1b]0;title\x07 rest", " rest"},
      {"\x1b]52;c;c2VjcmV0\x1b\\", ""},
      {"\x1bP+q544e\x1b\\", ""},
      {"12 \x1b]8;;http://x\x1b\\particles\x1b]8;;\x07 excluded", "12 particles excluded"},
      {"\x1b]0;unfinished\nnext", "\nnext"},
      {"p\bpart\u00adicles\u200b\u00a0ex\u00b0\b\b\bexcluded", "particles excluded"},
      {"\b\n\b\b.", "\n."},
      {"\x1b", ""},
      {"\x1b[", ""},
      {"\x1b[31", ""},
      {"\x1b[31\nm", "\nm"},
      {"a\x01\x02\x1f\x7f z", "a z"},
      {std::string("nul\0!", 5), "nul!"},
      {"failed\rpassed\b\b", "failedpass"},
      {"\u0085\u009b31mred", "31mred"},
      {"\u202Egnp.exe\u202C \u2066x\u2069\u200F\u061C", "gnp.exe x"},
      {"\xff\xfe latin \xe4", "\uFFFD\uFFFD latin \uFFFD"},
      {"\xed\xa0\x80", "\uFFFD\uFFFD\uFFFD"},
      {"cut \xe2\x82", "cut \uFFFD\uFFFD"},
      {"\uFFFF\uFFFE.", "."}};
  for (const auto& [text, shown] : texts)
    EXPECT_EQ(legible(text), shown) << ::testing::PrintToString(text);
}

TEST(Legible, LeavesWhatPeopleWrite) {
  for (const std::string text : {"", "a\tb\nc", "1 °C, ±0.5 m, π, 波, 🌊", "[31m", "\u200D"})
    EXPECT_EQ(legible(text), text);
}

TEST(LegibleMessage, ShortensALongLineAndNoOther) {
  const std::string as(10'000'000, 'a'), bs(400, 'b');
  EXPECT_EQ(legible_message("x: row = " + as + ": expected 2 values\n" + bs + "\n"),
            "x: row = " + as.substr(0, 491) + " ... (10000028 characters) ... " +
                as.substr(0, 281) + ": expected 2 values\n" + bs + "\n");
  EXPECT_EQ(legible_message("\x1b[31m" + bs), bs);
  EXPECT_EQ(legible_message(""), "");
}

}  // namespace
}  // namespace slosh::legible_text_test
