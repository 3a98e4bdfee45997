// The form of pages as a browser shows them: what is folded, what is left out, what fits.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "reports/model/report_files.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/headless_browser.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::page_form_test {
namespace {

class PageForm : public testing::Test {
 protected:
  void SetUp() override {
    if (!browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  }

  BrowserRun shown(const Report& report, const std::string& page = "index.html",
                   bool dark = false) {
    write_report(report, scratch_ / "report");
    return open_in_browser(scratch_.path(), "report/" + page, dark);
  }

  ScratchDirectory scratch_;
};

std::vector<int> counted(int last) {
  std::vector<int> numbers(static_cast<std::size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

Table long_table(std::size_t rows) {
  Table table{"long", "Runs", "", {"run", "error [%]"}, {}};
  for (std::size_t i = 0; i < rows; ++i)
    table.rows.push_back({"run_" + std::to_string(i), std::to_string(i)});
  return table;
}

TEST_F(PageForm, NumbersFiguresAndTablesFromOneOnEachPage) {
  for (const auto& [page, figures, tables] :
       {std::tuple{"index.html", 0, 1}, {"waves.html", 4, 0}, {"cost.html", 1, 1}}) {
    const BrowserRun run = shown(paged_report(), page);
    EXPECT_EQ(run.desk.at("figure_numbers"), counted(figures)) << page;
    EXPECT_EQ(run.desk.at("table_numbers"), counted(tables)) << page;
  }
}

TEST_F(PageForm, FoldsReasonsUntilTheyAreAskedFor) {
  Report report = sample_report();
  const BrowserRun without = shown(report);
  Table& gate = report.sections[0].tables[0];
  gate.reasons.assign(gate.rows.size(), "");
  gate.reasons[0] = gate.reasons[2] = "A good many words that tell why the limit is what it is.";
  for (const bool dark : {false, true}) {
    const BrowserRun run = shown(report, "index.html", dark);
    for (const auto& [page, plain] :
         {std::pair{run.phone, without.phone}, {run.desk, without.desk}}) {
      EXPECT_EQ(page.at("folded_reasons"), 2);
      EXPECT_EQ(page.at("words"), plain.at("words").get<int>() + 2) << "the word Reason, twice";
      EXPECT_LE(page.at("scroll_width"), page.at("width"));
    }
  }
}

TEST_F(PageForm, SaysOfATableThatItScrollsWhereItDoes) {
  const BrowserRun run = shown(sample_report());
  EXPECT_EQ(run.phone.at("wide_boxes"), 2);
  EXPECT_EQ(run.desk.at("wide_boxes"), 0);
  EXPECT_EQ(run.phone.at("unhinted_boxes"), 0);
  EXPECT_EQ(run.desk.at("unhinted_boxes"), 0);
}

TEST_F(PageForm, ShowsTheBeginningOfALongTableAndKeepsAllOfItInAFile) {
  Report report = sample_report();
  report.sections[2].tables = {long_table(400)};
  const BrowserRun run = shown(report);
  EXPECT_EQ(run.desk.at("table_rows").at("table-long"), 100);
  const std::string file = read_text(scratch_ / "report/tables/long.csv");
  EXPECT_EQ(std::count(file.begin(), file.end(), '\n'), 401);
  EXPECT_TRUE(file.ends_with("run_399,399\n"));
  report.sections[2].tables = {long_table(100)};
  EXPECT_EQ(shown(report).desk.at("table_rows").at("table-long"), 100);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "report/tables"));
}

TEST_F(PageForm, WeighsLittleWithFourHundredRuns) {
  Report report = sample_report();
  Section& section = report.sections[1];
  section.figures.clear();
  for (int i = 0; i < 12; ++i) {
    Figure figure = heavy_figure("heavy-" + std::to_string(i));
    const std::vector<Curve> curves = figure.curves;
    while (figure.curves.size() < 400)
      figure.curves.insert(figure.curves.end(), curves.begin(), curves.end());
    section.figures.push_back(std::move(figure));
  }
  section.tables = {long_table(400)};
  const BrowserRun run = shown(report);
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    EXPECT_LT(page.at("weight"), 1'500'000);
    EXPECT_EQ(page.at("cut_figures"), 0);
    EXPECT_EQ(page.at("drawings"), 13);
  }
}

TEST_F(PageForm, SaysHowManyCurvesOfAFigureAreDrawn) {
  Figure figure = heavy_figure("many");
  while (figure.curves.size() < 400) figure.curves.push_back(figure.curves.front());
  Report report = sample_report();
  report.sections[1].figures = {figure};
  const Report legible = with_legible_figures(report);
  EXPECT_EQ(legible.sections[1].figures[0].curves.size(), most_curves);
  EXPECT_EQ(legible.sections[1].figures[0].caption, "The first 24 of 400 curves are drawn.");
  EXPECT_EQ(with_legible_figures(sample_report()).sections[1].figures[0].caption,
            sample_report().sections[1].figures[0].caption);
}

}  // namespace
}  // namespace slosh::reports::page_form_test
