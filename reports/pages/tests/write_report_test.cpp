#include "reports/pages/write_report.hpp"

#include <gtest/gtest.h>

#include <boost/process/search_path.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>

#include "reports/model/report_files.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::write_report_test {
namespace {

namespace fs = std::filesystem;

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::size_t entries(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), {}));
}

TEST(WrittenReport, HasAllItsFilesUniqueIdsAndNoLinkToNowhereAndLeavesNothingBeside) {
  const ScratchDirectory scratch;
  write_report(sample_report(), scratch / "campaign/report/");
  for (const char* name :
       {"index.html", "results.json", "figures/time-history.svg", "results.schema.json",
        "figures/cost.svg", "figures/pressure-field.png"}) {
    EXPECT_TRUE(fs::is_regular_file(scratch / "campaign/report" / name)) << name;
  }
  EXPECT_EQ(entries(scratch / "campaign"), 1u);
  EXPECT_EQ(entries(scratch / "campaign/report"), 5u) << "with the list of what was made";
  EXPECT_EQ(read_text(scratch / "campaign/report/results.json"), sample_report().results_json);
  const std::string page = read_text(scratch / "campaign/report/index.html");
  std::set<std::string> ids;
  const std::regex id(R"( id=["']([^"']*)["'])"), target(R"(href=["']#([^"']*)["'])");
  for (std::sregex_iterator match(page.begin(), page.end(), id), end; match != end; ++match) {
    EXPECT_TRUE(ids.insert((*match)[1]).second) << (*match)[1] << " twice";
  }
  for (std::sregex_iterator match(page.begin(), page.end(), target), end; match != end; ++match) {
    EXPECT_TRUE(ids.contains((*match)[1])) << (*match)[1];
  }
}

TEST(WrittenReport, StandsAloneAndTellsItsVerdictBeforeAllElse) {
  const ScratchDirectory scratch;
  Report report = sample_report();
  for (const auto& [outcome, shown] :
       {std::pair{Outcome::pass, "</span> Pass</strong>"},
        {Outcome::watched,
         "verdict watched\"><strong><span aria-hidden=\"true\">–</span> "
         "Watched, not validated</strong>"},
        {Outcome::inconclusive, "</span> Inconclusive</strong>"},
        {Outcome::not_compared, "</span> Not compared</strong>"},
        {Outcome::fail, "</span> Fail</strong>"}}) {
    report.outcome = outcome;
    write_report(report, scratch / "report");
    const std::string page = read_text(scratch / "report/index.html");
    EXPECT_LT(page.find("class=\"verdict"), page.find("<nav"));
    EXPECT_TRUE(holds(page, shown));
  }
  const std::string page = read_text(scratch / "report/index.html");
  EXPECT_EQ(occurrences(page, "://"), occurrences(page, "xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(occurrences(page, " src="), occurrences(page, " src=\"data:image/png;base64,"));
  EXPECT_EQ(occurrences(page, "<script") + occurrences(page, "@import"), 0u);
  for (const char* part :
       {"Figure 4. Pressure in the rolling tank", "Figure 5. Error against run time",
        "alt=\"Pressure in the rolling tank. Panels: SPH &lt;recommended&gt;"})
    EXPECT_TRUE(holds(page, part)) << part;
}

TEST(WrittenReport, LeadsFromItsBannerToTheRowThatDecidesFoldsATableAndPlaysAnAnimationIfAsked) {
  const ScratchDirectory scratch;
  Report report = sample_report();
  Section& section = report.sections.front();
  report.decision = {
      "Decided by", {"surge: 10 mm <coarse>", "section-" + section.id}, "7 % > 5 %."};
  report.coverage = "4 of 5 rows are judged.";
  report.doubts = {"doubtful: sph <coarse>"};
  Table& table = section.tables.front();
  table.is_folded = true;
  report.sections[1].fields.push_back(sloshing_animation("flow", 2, 2, 0.03));
  write_report(report, scratch / "report");
  const std::string page = read_text(scratch / "report/index.html");
  EXPECT_TRUE(holds(page, "Decided by <a href=\"#section-" + section.id +
                              "\">surge: 10 mm &lt;coarse&gt;</a>: 7 % &gt; 5 %."));
  EXPECT_LT(page.find("4 of 5 rows are judged."), page.find(report.subtitle));
  EXPECT_LT(page.find("doubtful: sph &lt;coarse&gt;"), page.find("4 of 5 rows are judged."));
  const std::size_t folded = page.find("<details class=\"folded\"><summary>");
  ASSERT_NE(folded, std::string::npos);
  EXPECT_LT(page.find(": " + std::to_string(table.rows.size()) + "</summary>", folded),
            page.size());
  EXPECT_LT(page.find("id=\"table-" + table.id + "\"", folded), page.find("</details>\n", folded));
  const std::size_t play =
      page.find("<details><summary>Play</summary><a href=\"figures/flow.gif\">");
  ASSERT_NE(play, std::string::npos);
  EXPECT_LT(page.find("data:image/gif;base64,", play), page.find("</details>", play));
  EXPECT_TRUE(fs::is_regular_file(scratch / "report/figures/flow.gif"));
  report.decision.row.anchor = "row-nowhere";
  EXPECT_THROW(check_report(report), ReportError);
  report.decision = {};
  EXPECT_NO_THROW(check_report(report));
  report.sections[1].fields.back().panels.pop_back();
  EXPECT_THROW(check_report(report), ReportError) << "a row that is not whole";
}

TEST(PagedReport, HasAFileForEachPageWithItsOwnSectionsAndVerdictAndLeadsFromAPageToItsAppendix) {
  const ScratchDirectory scratch;
  const auto page = [&](const std::string& name) {
    return read_text(scratch / "report" / (name + ".html"));
  };
  Report report = paged_report();
  write_report(report, scratch / "report");
  EXPECT_EQ(entries(scratch / "report"), 7u);
  const std::string cost = page("cost"), waves = page("waves");
  EXPECT_EQ(occurrences(page("index"), "<figure"), 0u);
  EXPECT_EQ(occurrences(waves, "<figure"), 4u);
  EXPECT_EQ(occurrences(cost, "<figure"), 1u);
  EXPECT_TRUE(holds(cost, "Figure 1. Error against run time"));
  EXPECT_TRUE(holds(waves, "<h1>Waves &amp; wind</h1>"));
  EXPECT_EQ(occurrences(waves, "class=\"verdict good\""), 1u);
  EXPECT_EQ(occurrences(cost, "class=\"verdict"), 0u);
  EXPECT_TRUE(holds(page("index"), "<a href=\"cost.html#row-runs-2\">"));
  report.pages[1].continues = "waves";
  write_report(report, scratch / "report");
  EXPECT_FALSE(holds(page("index"), "href=\"cost.html\">"));
  EXPECT_TRUE(holds(page("index"), "<li><a class=\"glance-title\" href=\"waves.html\">"));
  EXPECT_TRUE(holds(page("waves"), "<li><a href=\"cost.html\""));
}

TEST(PagedReport, LosesThePagesThatANewerOneHasNot) {
  const ScratchDirectory scratch;
  write_report(paged_report(), scratch / "report");
  write_report(sample_report(), scratch / "report");
  EXPECT_FALSE(fs::exists(scratch / "report/waves.html"));
  write_text(scratch / "report/waves.html", "<p>somebody's own");
  write_report(sample_report(), scratch / "report");
  EXPECT_EQ(read_text(scratch / "report/waves.html"), "<p>somebody's own");
}

TEST(WrittenReport, ReplacesTheOldOneWholeAndKeepsItWhereGnuplotIsMissing) {
  const ScratchDirectory scratch;
  write_report(sample_report(), scratch / "report");
  const std::string old = read_text(scratch / "report/index.html");
  Report second = sample_report();
  second.title = "second";
  second.sections.pop_back();
  {
    const PathVariable path("");
    EXPECT_THROW(write_report(second, scratch / "report"), ReportError);
  }
  EXPECT_EQ(read_text(scratch / "report/index.html"), old);
  EXPECT_EQ(entries(scratch.path()), 1u);
  write_report(second, scratch / "report");
  EXPECT_TRUE(holds(read_text(scratch / "report/index.html"), "<h1>second</h1>"));
  EXPECT_FALSE(fs::exists(scratch / "report/figures/cost.svg"));
  EXPECT_EQ(entries(scratch.path()), 1u);
}

// Tells whether two gnuplot processes ran at the same time.
bool draws_together(int threads) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "bin");
  const std::string busy = (scratch / "busy").string(), together = (scratch / "together").string();
  std::ofstream(scratch / "bin/gnuplot")
      << "#!/bin/sh\nmkdir " << busy << " 2>/dev/null || touch " << together << "\nsleep 0.2\n"
      << boost::process::search_path("gnuplot").string() << " \"$@\"\nstatus=$?\nrmdir " << busy
      << " 2>/dev/null\nexit $status\n";
  fs::permissions(scratch / "bin/gnuplot", fs::perms::owner_all);
  const PathVariable path((scratch / "bin").string() + ":" + std::getenv("PATH"));
  write_report(sample_report(), scratch / "report", {.threads = threads});
  return fs::exists(together);
}

TEST(WrittenReport, IsDrawnByAsManyGnuplotsAsItIsTold) {
  EXPECT_FALSE(draws_together(1));
  EXPECT_TRUE(draws_together(3));
}

// A file of somebody's stays where it is; in the place of a page it is set aside.
TEST(WrittenReport, LosesNothingOfSomebodys) {
  Report report = sample_report();  // of one picture, as it is written often
  report.sections.pop_back();
  report.sections[1].figures.resize(1);
  report.sections[1].fields.clear();
  for (const char* own :
       {"index.html", "results.json", "figures/tank.svg", "tables/tank.csv", "report.md",
        "figures/old/tank.svg", "tables/motion.toml", "figures", ".DS_Store", "index.html~"}) {
    const ScratchDirectory scratch;
    const fs::path file = scratch / "report" / own;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "years of work";
    for (int i = 0; i < 2; ++i) write_report(report, scratch / "report");
    const fs::path kept = file.native() + ".kept-1";
    EXPECT_EQ(read_text(fs::exists(kept) ? kept : file), "years of work") << own;
    EXPECT_TRUE(holds(read_text(scratch / "report/index.html"), "<html")) << own;
    EXPECT_TRUE(fs::is_directory(scratch / "report/figures"));
  }
  const ScratchDirectory scratch;
  std::ofstream(scratch / "thesis.tex") << "years of work";
  write_report(report, scratch / "thesis.tex");
  EXPECT_EQ(read_text(scratch / "thesis.tex.kept-1"), "years of work");
}

TEST(WrittenReport, KeepsAPageThatSomebodyEdited) {
  for (const char* page : {"index.html", "waves.html", "results.json"}) {
    const ScratchDirectory scratch;
    write_report(paged_report(), scratch / "report");
    write_text(scratch / "report" / page, "edited");
    write_report(paged_report(), scratch / "report");
    EXPECT_EQ(read_text(scratch / "report" / (page + std::string(".kept-1"))), "edited");
    EXPECT_NE(read_text(scratch / "report" / page), "edited");
  }
}

// What makes a sound report faulty, and why it is.
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
struct Fault {
  const char* why;
  void (*spoil)(Report&);
};
#define FAULT(why, ...)                 \
  Fault {                               \
    why, [](Report& r) { __VA_ARGS__; } \
  }
#define TABLE(section) r.sections[section].tables[0]
#define CURVE(section) r.sections[section].figures[0].curves[0]
#define FIELD r.sections[1].fields[0]

TEST(FaultyReport, IsRefusedBeforeAnythingIsWritten) {
  const Fault faults[] = {
    FAULT("not JSON", r.results_json = "{\"error\": nan}"),
    FAULT("cut JSON", r.results_json.resize(r.results_json.size() / 2)),
    FAULT("no JSON", r.results_json.clear()),
    FAULT("path in an id", r.sections[1].figures[0].id = "../wave"),
    FAULT("no id", r.sections[0].id.clear()),
    FAULT("id twice", r.sections[1].figures[0].id = "cost"),
    FAULT("short row", TABLE(0).rows[1].pop_back()),
    FAULT("page of nowhere", r.sections[1].page = "nowhere"),
    FAULT("page without a section", r.pages = {{"empty", "", "", {}}}),
    FAULT("a second first page", r.pages = {{"index", "", "", {}}}; r.sections[1].page = "index"),
    FAULT("short reasons", TABLE(0).reasons = {"a"}),
    FAULT("an appendix of another page",
          r.pages = {{"waves", "", "", {}}, {"cost", "", "", {}, "index"}};
          r.sections[1].page = "waves"; r.sections[2].page = "cost"),
    FAULT("short row ids", TABLE(0).row_ids = {"a"}),
    FAULT("row id twice", (TABLE(2).row_ids = {"a", "a"})),
    FAULT("link to nowhere", TABLE(2).links = {{"row-a", "", "", ""}, {"", "", "", ""}}),
    FAULT("short links", TABLE(2).links = {{"section-cost"}, {""}}),
    FAULT("short curve", CURVE(1).y.pop_back()),
    FAULT("short bars", CURVE(2).y_error.pop_back()),
    FAULT("short level bars", CURVE(2).x_error = {1}),
    FAULT("a ribbon with one edge", CURVE(1).lower = CURVE(1).y),
    FAULT("a short ribbon", CURVE(1).lower = CURVE(1).upper = {1}),
    FAULT("equal logarithmic axes", r.sections[2].figures[0].equal_axes = true),
    FAULT("turned range", (r.sections[1].figures[0].x_range = {2, 1})),
    FAULT("zero on a logarithmic axis", (r.sections[2].figures[0].x_range = {0, 1})),
    FAULT("a figure's id", FIELD.id = "cost"),
    FAULT("no panels", FIELD.panels.clear()),
    FAULT("no columns", FIELD.columns = 0),
    FAULT("more panels in a row than fit", FIELD.columns = 35;
          FIELD.panels.resize(35, FIELD.panels[0])),
    FAULT("turned colours", (FIELD.value_range = {1, 0})),
    FAULT("undefined colours", (FIELD.value_range = {nan, nan})),
    FAULT("colours that are one", (FIELD.value_range = {1000, 1000 + 1e-9})),
    FAULT("negative arrows", FIELD.arrow_scale = -1),
    FAULT("undefined arrows", FIELD.arrow_scale = nan),
    FAULT("short values", FIELD.panels[2].value.pop_back()),
    FAULT("short places", FIELD.panels[2].z.pop_back()),
    FAULT("short arrows", FIELD.panels[2].arrow_w.pop_back()),
    FAULT("flat tank", FIELD.panels[2].tank_height = 0),
    FAULT("undefined tank", FIELD.panels[2].tank_length = nan),
    FAULT("an outline of two corners", (FIELD.panels[2].outline = {{0, 0}, {1, 0}})),
    FAULT("an undefined corner", (FIELD.panels[2].outline = {{0, 0}, {1, 0}, {1, nan}})),
    FAULT("points of no size", FIELD.panels[2].point_width = -0.01),
    FAULT("undefined roll", FIELD.panels[2].angle = nan),
    FAULT("undefined axis", FIELD.panels[2].axis_z = nan)
  };
  for (const Fault& fault : faults) {
    const ScratchDirectory scratch;
    Report report = sample_report();
    fault.spoil(report);
    EXPECT_THROW(write_report(report, scratch / "report"), ReportError) << fault.why;
    EXPECT_EQ(entries(scratch.path()), 0u) << fault.why;
  }
}

#undef FAULT
#undef TABLE
#undef CURVE
#undef FIELD

}  // namespace
}  // namespace slosh::reports::write_report_test
