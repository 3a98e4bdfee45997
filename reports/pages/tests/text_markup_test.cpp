#include "reports/pages/text_markup.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace slosh::reports::text_markup_test {
namespace {

using Texts = std::vector<std::pair<const char*, const char*>>;

TEST(HtmlText, EscapesAllThatHtmlReadsShowsCodeAndMayBreakALongNameAfterItsUnderscores) {
  for (const auto& [text, html] :
       Texts{{"linear_two_layer", "linear_<wbr>two_<wbr>layer"},
             {"`linear_two_layer`", "<code>linear_two_layer</code>"},
             {"<script>a && b</script> \"'",
              "&lt;script&gt;a &amp;&amp; b&lt;/script&gt; &quot;&apos;"},
             {"run `a < b` now", "run <code>a &lt; b</code> now"},
             {"one ` only", "one ` only"},
             {"`a` and `b", "<code>a</code> and `b"}})
    EXPECT_EQ(html_text(text), html);
}

TEST(MarkdownText, EscapesAllThatMarkdownReadsAndStaysInsideItsTableCell) {
  for (const auto& [text, markdown] :
       Texts{{"a*b_c [x](y) <i> #1 ~z~ $t$ & \\",
              R"(a\*b\_c \[x\](y) &lt;i&gt; \#1 \~z\~ \$t\$ &amp; \\)"},
             {"one ` only", "one \\` only"},
             {"`<b>x</b>`", "\\`&lt;b&gt;x&lt;/b&gt;\\`"},
             {"`a\\|<b>`", "\\`a\\\\\\|&lt;b&gt;\\`"},
             {"``<b>``", "\\`\\`&lt;b&gt;\\`\\`"},
             {"a | b\nc", "a \\| b c"},
             {"`a | b`", "`a \\| b`"},
             {"- 5 mm", "\\- 5 mm"},
             {"1. first", "1\\. first"},
             {"1.5 mm", "1.5 mm"}})
    EXPECT_EQ(markdown_text(text), markdown);
}

TEST(CellVerdicts, AreReadInAnyCaseFromTheWholeCellOrBeforeAColon) {
  const std::pair<CellVerdict, std::vector<const char*>> kinds[]{
      {CellVerdict::good, {"pass", "PASS", "Confirmed", "validated", "pass: 0.3 ± 0.1 %"}},
      {CellVerdict::bad,
       {"FAIL", "violated", "solver failed", "Not compared", "no result", "refuted"}},
      {CellVerdict::neutral,
       {"watched, not validated", "not selected", "out of range", "not decidable", "Not supplied",
        "skipped"}},
      {CellVerdict::unsure, {"inconclusive", "inconclusive: 3 %"}},
      {CellVerdict::none, {"low-pass filter", "passes: 3"}}};
  for (const auto& [kind, cells] : kinds)
    for (const char* cell : cells) EXPECT_EQ(cell_verdict(cell), kind) << cell;
  EXPECT_EQ(verdict_sign(CellVerdict::unsure), "?");
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
