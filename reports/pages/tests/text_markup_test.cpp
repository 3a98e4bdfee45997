#include "reports/pages/text_markup.hpp"

#include <gtest/gtest.h>

namespace slosh::reports::text_markup_test {
namespace {

TEST(HtmlText, MayBreakALongNameAfterItsUnderscoresButNoCode) {
  EXPECT_EQ(html_text("linear_two_layer"), "linear_<wbr>two_<wbr>layer");
  EXPECT_EQ(html_text("`linear_two_layer`"), "<code>linear_two_layer</code>");
}

TEST(HtmlText, EscapesEverythingThatHtmlReads) {
  EXPECT_EQ(html_text("<script>a && b</script> \"'"),
            "&lt;script&gt;a &amp;&amp; b&lt;/script&gt; &quot;&apos;");
}

TEST(HtmlText, ShowsTextBetweenBackticksAsCode) {
  EXPECT_EQ(html_text("run `a < b` now"), "run <code>a &lt; b</code> now");
  EXPECT_EQ(html_text("one ` only"), "one ` only");
  EXPECT_EQ(html_text("`a` and `b"), "<code>a</code> and `b");
}

TEST(MarkdownText, EscapesEverythingThatMarkdownReads) {
  EXPECT_EQ(markdown_text("a*b_c [x](y) <i> #1 ~z~ $t$ & \\"),
            R"(a\*b\_c \[x\](y) &lt;i&gt; \#1 \~z\~ \$t\$ &amp; \\)");
  EXPECT_EQ(markdown_text("one ` only"), "one \\` only");
}

TEST(MarkdownText, HoldsNoTagInCodeEither) {
  EXPECT_EQ(markdown_text("`<b>x</b>`"), "\\`&lt;b&gt;x&lt;/b&gt;\\`");
  EXPECT_EQ(markdown_text("`a\\|<b>`"), "\\`a\\\\\\|&lt;b&gt;\\`");
  EXPECT_EQ(markdown_text("``<b>``"), "\\`\\`&lt;b&gt;\\`\\`");
}

TEST(MarkdownText, StaysInsideItsTableCell) {
  EXPECT_EQ(markdown_text("a | b\nc"), "a \\| b c");
  EXPECT_EQ(markdown_text("`a | b`"), "`a \\| b`");
}

TEST(MarkdownText, StartsNoListByAccident) {
  EXPECT_EQ(markdown_text("- 5 mm"), "\\- 5 mm");
  EXPECT_EQ(markdown_text("1. first"), "1\\. first");
  EXPECT_EQ(markdown_text("1.5 mm"), "1.5 mm");
}

TEST(CellVerdicts, AreReadInAnyCaseAndOnlyFromTheWholeCell) {
  EXPECT_EQ(cell_verdict("pass"), CellVerdict::good);
  EXPECT_EQ(cell_verdict("PASS"), CellVerdict::good);
  EXPECT_EQ(cell_verdict("Confirmed"), CellVerdict::good);
  EXPECT_EQ(cell_verdict("validated"), CellVerdict::good);
  EXPECT_EQ(cell_verdict("watched, not validated"), CellVerdict::neutral);
  for (const char* bad :
       {"FAIL", "violated", "solver failed", "Not compared", "no result", "refuted"}) {
    EXPECT_EQ(cell_verdict(bad), CellVerdict::bad) << bad;
  }
  for (const char* neutral :
       {"not selected", "out of range", "not decidable", "Not supplied", "skipped"}) {
    EXPECT_EQ(cell_verdict(neutral), CellVerdict::neutral) << neutral;
  }
  EXPECT_EQ(cell_verdict("low-pass filter"), CellVerdict::none);
}

TEST(CellVerdicts, MayGoOnAfterAColon) {
  EXPECT_EQ(cell_verdict("pass: 0.3 ± 0.1 %"), CellVerdict::good);
  EXPECT_EQ(cell_verdict("inconclusive"), CellVerdict::unsure);
  EXPECT_EQ(verdict_sign(cell_verdict("inconclusive: 3 %")), "?");
  EXPECT_EQ(cell_verdict("passes: 3"), CellVerdict::none);
}

TEST(NumericCells, AreNumbersWithOrWithoutUnitAndUncertainty) {
  for (const char* number :
       {"1", "-1.25e-3", "+3.1 %", "12 ± 0.4 mm", "<= 5 %", "≤ 1.5 deg", "nan", "-", "−2.5"}) {
    EXPECT_TRUE(is_numeric(number)) << number;
  }
  for (const char* text :
       {"li2010", "interFoam 5 mm", "3 of the 5 runs", "amplitude", "`./slosh`"}) {
    EXPECT_FALSE(is_numeric(text)) << text;
  }
}

}  // namespace
}  // namespace slosh::reports::text_markup_test
