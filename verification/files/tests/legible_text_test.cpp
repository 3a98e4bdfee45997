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
      {"\x1b]0;title\x07 rest", "]0;title rest"},
      {"\x1b]52;c;c2VjcmV0\x1b\\", "]52;c;c2VjcmV0\\"},
      {"\x1bP+q544e\x1b\\", "P+q544e\\"},
      {"\x1b", ""},
      {"\x1b[", ""},
      {"\x1b[31", ""},
      {"\x1b[31\nm", "\nm"},
      {"a\x01\x02\x1f\x7f z", "a z"},
      {std::string("nul\0!", 5), "nul!"},
      {"failed\rpassed\b\b", "failedpassed"},
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

}  // namespace
}  // namespace slosh::legible_text_test
