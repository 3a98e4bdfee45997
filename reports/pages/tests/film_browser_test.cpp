// An animation as a browser shows it: where its panels and its cursor stand, what moves with the
// slider, and what stays without a script and in print.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/model/report_files.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/headless_browser.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::film_browser_test {
namespace {

// Opens the report in frames of a desk's and of a phone's width, without scripts, and with the
// rules for print at the width of A4, and measures each state of its animation.
constexpr const char* measuring_page = R"(<!DOCTYPE html><title>measure</title>
<iframe class="live" src="report/index.html" style="width:1280px;height:800px;border:0"></iframe>
<iframe class="live" src="report/index.html" style="width:390px;height:844px;border:0"></iframe>
<iframe sandbox="allow-same-origin" src="report/index.html" style="width:1280px;height:800px;border:0"></iframe>
<iframe class="printed" src="report/index.html" style="width:688px;height:900px;border:0"></iframe>
<pre id="measures"></pre>
<script>
const box = element => {
  const {left, top, right, bottom} = element.getBoundingClientRect();
  return {left, top, right, bottom};
};
const state = frame => {
  const page = frame.contentDocument, film = page.querySelector('.film');
  const all = query => [...film.querySelectorAll(query)];
  const cursor = box(film.querySelector('.film-cursor'));
  const frames = all('.film-frame').map(part => ({part, style: frame.contentWindow.getComputedStyle(part)}));
  return {
    width: page.documentElement.clientWidth,
    scroll_width: page.documentElement.scrollWidth,
    panels: all('.film-panel').map(box),
    frames: frames.map(({part}) => box(part)),
    rows: frames.map(({style}) => parseFloat(style.backgroundPosition.split(' ')[1])),
    columns: frames.map(({style}) => parseFloat(style.backgroundPosition)),
    pictures: new Set(frames.map(({style}) => style.backgroundImage)).size,
    has_picture: frames[0].style.backgroundImage.startsWith('url("data:image/png'),
    names: all('.film-name').map(name => name.firstChild.textContent.trim()),
    missing: all('.film-missing').map(note => note.checkVisibility()),
    bars: all('.film-bar').map(box),
    controls: all('button, input').filter(part => part.checkVisibility()).map(box),
    button: film.querySelector('button').textContent,
    slider: Number(film.querySelector('input').value),
    time: film.querySelector('output').textContent,
    time_is_seen: film.querySelector('output').checkVisibility(),
    cursor,
    history: box(film.querySelector('svg:not(.film-bar)')),
    // The labels of the time axis, which stand below the cursor.
    ticks: all('svg:not(.film-bar) text').map(text => ({time: parseFloat(text.textContent), at: box(text)})).filter(({time, at}) => time > 0 && at.top > cursor.bottom),
  };
};
const move_to = (frame, number) => {
  const slider = frame.contentDocument.querySelector('.film input');
  slider.value = number;
  slider.dispatchEvent(new Event('input'));
  return state(frame);
};
// Lets the page's rules for print count, and none of those for the screen.
const print = frame => {
  for (const sheet of frame.contentDocument.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule instanceof frame.contentWindow.CSSMediaRule) {
        if (rule.media.mediaText == 'print') rule.media.mediaText = 'all';
        else if (rule.media.mediaText.includes('screen')) rule.media.mediaText = 'not all';
      }
  frame.contentWindow.dispatchEvent(new Event('beforeprint'));
  const printed = state(frame);
  frame.contentWindow.dispatchEvent(new Event('afterprint'));
  return {printed, after: state(frame)};
};
const tick = ms => new Promise(done => setTimeout(done, ms));
addEventListener('load', async () => {
  const [, , still, paper] = document.querySelectorAll('iframe'), runs = [];
  for (const frame of document.querySelectorAll('.live')) {
    const last = Number(frame.contentDocument.querySelector('.film input').max);
    const poster = state(frame), button = frame.contentDocument.querySelector('.film button');
    await tick(400);
    const waited = state(frame);
    button.click();
    const started = state(frame);
    await tick(150);
    const playing = state(frame);
    button.click();
    const moments = [];
    for (let number = 0; number <= last; ++number) moments.push(move_to(frame, number));
    runs.push({poster, waited, started, playing, moments});
  }
  move_to(paper, 0);
  document.getElementById('measures').textContent = JSON.stringify({desk: runs[0], phone: runs[1], without_script: state(still), print: print(paper)});
});
</script>)";

constexpr int moments = 5, poster = 2;

double at(const nlohmann::json& box, const char* side) { return box.at(side).get<double>(); }

// What is wrong with a state of an animation, one sentence for each fault.
std::vector<std::string> faults(const nlohmann::json& state) {
  std::vector<std::string> found;
  const auto expect = [&](bool holds, const std::string& fault) {
    if (!holds) found.push_back(fault);
  };
  expect(at(state, "scroll_width") <= at(state, "width"), "The page is wider than the screen.");
  const nlohmann::json& frames = state.at("frames");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    expect(at(frames[i], "left") >= 0 && at(frames[i], "right") <= at(state, "width"),
           "A panel leaves the page.");
    expect(at(frames[i], "right") - at(frames[i], "left") >= 140, "A panel is small.");
    expect(state.at("rows")[i] == state.at("rows")[0], "The panels show different moments.");
    for (std::size_t j = 0; j < i; ++j) {
      expect(at(frames[i], "left") >= at(frames[j], "right") ||
                 at(frames[i], "top") >= at(frames[j], "bottom"),
             "Two panels overlap.");
      expect(state.at("columns")[i] != state.at("columns")[j], "Two panels show the same run.");
    }
    expect(at(frames[i], "bottom") <= at(state.at("history"), "top"), "The history is not below.");
  }
  expect(state.at("pictures") == 1 && state.at("has_picture"), "The panels lack their picture.");
  expect(state.at("bars").size() == 1, "There is not one colour bar.");
  expect(state.at("time_is_seen"), "The time is hidden.");
  // The cursor against the axis' own labels.
  const nlohmann::json& ticks = state.at("ticks");
  if (ticks.size() < 2) return found.push_back("The time axis has no labels."), found;
  const auto middle = [](const nlohmann::json& box) {
    return (at(box, "left") + at(box, "right")) / 2;
  };
  const nlohmann::json &first = ticks.front(), &last = ticks.back();
  const double time = std::stod(state.at("time").get<std::string>().substr(4)) / 100;  // from cs
  const double place =
      middle(first.at("at")) + (time - at(first, "time")) / (at(last, "time") - at(first, "time")) *
                                   (middle(last.at("at")) - middle(first.at("at")));
  expect(std::abs(middle(state.at("cursor")) - place) <= 1.5,
         "The cursor is not at its time on the axis.");
  return found;
}

using Faults = std::vector<std::string>;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class FilmInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
    Report report = sample_report();
    report.sections[1].figures.resize(1);
    report.sections[1].fields = {sloshing_film("film", moments, 3, 0.02)};
    write_report(report, scratch_ / "report");
  }

  nlohmann::json measured(bool dark = false) {
    const MeasuredPage run = measure_in_browser(scratch_.path(), measuring_page, dark);
    log_ = run.log;
    return run.measures;
  }

  void replace(const std::string& from, const std::string& to) {
    const auto page = scratch_ / "report/index.html";
    std::string text = read_text(page);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    write_text(page, text);
  }

  ScratchDirectory scratch_;
  std::string log_;
};

TEST_F(FilmInBrowser, StandsSideBySideOnADeskAndInTwoColumnsOnAPhone) {
  for (const bool dark : {false, true}) {
    const nlohmann::json run = measured(dark);
    // The frame without scripts says that it blocks them, and nothing else is said.
    EXPECT_EQ(count(log_, "CONSOLE"), count(log_, "\"Blocked script execution in ")) << log_;
    const nlohmann::json &desk = run.at("desk").at("poster"), &phone = run.at("phone").at("poster");
    EXPECT_EQ(desk.at("width"), 1280);
    EXPECT_EQ(phone.at("width"), 390);
    for (const nlohmann::json& state : {desk, phone}) {
      EXPECT_EQ(faults(state), Faults{}) << state.dump(1);
      EXPECT_EQ(state.at("names"),
                (nlohmann::json{"SPH <recommended>", "li2010_20mm", "interfoam_30x30"}));
      EXPECT_EQ(state.at("controls").size(), 2);
      for (const nlohmann::json& control : state.at("controls"))
        EXPECT_LE(at(control, "right"), at(state, "width"));
    }
    const auto top = [](const nlohmann::json& state, int panel) {
      return at(state.at("panels")[static_cast<std::size_t>(panel)], "top");
    };
    EXPECT_EQ(top(desk, 1), top(desk, 0));
    EXPECT_EQ(top(desk, 2), top(desk, 0));
    EXPECT_EQ(top(phone, 1), top(phone, 0));
    EXPECT_GT(top(phone, 2), top(phone, 0));
    // Panels, controls and history fit on one screen of a desk together.
    EXPECT_LE(at(desk.at("history"), "bottom") - at(desk.at("bars")[0], "top"), 900);
  }
}

TEST_F(FilmInBrowser, StandsAtItsPosterUntilItIsPlayedAndPlaysFromTheStart) {
  const nlohmann::json run = measured();
  for (const char* width : {"desk", "phone"}) {
    const nlohmann::json& states = run.at(width);
    for (const char* state : {"poster", "waited"}) {
      EXPECT_EQ(states.at(state).at("slider"), poster);
      EXPECT_EQ(states.at(state).at("time"), "t = 250 cs");
      EXPECT_EQ(states.at(state).at("rows")[0], 50);
      EXPECT_EQ(states.at(state).at("button"), "Play");
    }
    EXPECT_EQ(states.at("started").at("slider"), 0);
    EXPECT_EQ(states.at("started").at("button"), "Pause");
    EXPECT_GE(states.at("playing").at("slider"), 1);
    EXPECT_EQ(faults(states.at("started")), Faults{});
    EXPECT_EQ(faults(states.at("playing")), Faults{});
  }
}

TEST_F(FilmInBrowser, MovesAllPanelsTheTimeAndTheCursorWithItsSlider) {
  const nlohmann::json run = measured();
  for (const char* width : {"desk", "phone"}) {
    const nlohmann::json& states = run.at(width).at("moments");
    ASSERT_EQ(states.size(), moments);
    for (std::size_t i = 0; i < states.size(); ++i) {
      EXPECT_EQ(faults(states[i]), Faults{}) << states[i].dump(1);
      EXPECT_EQ(states[i].at("time"), "t = " + std::to_string(200 + 25 * i) + " cs");
      EXPECT_NEAR(states[i].at("rows")[2].get<double>(), 25.0 * static_cast<double>(i), 0.01);
      EXPECT_EQ(states[i].at("button"), "Play");
      EXPECT_EQ(states[i].at("missing"), (nlohmann::json{false, i == 1, false}));
      if (i > 0)
        EXPECT_GT(at(states[i].at("cursor"), "left"), at(states[i - 1].at("cursor"), "left") + 50);
    }
  }
}

TEST_F(FilmInBrowser, ShowsItsPosterWithoutScriptAndInPrint) {
  const nlohmann::json run = measured();
  for (const nlohmann::json& state : {run.at("without_script"), run.at("print").at("printed")}) {
    EXPECT_EQ(faults(state), Faults{}) << state.dump(1);
    EXPECT_EQ(state.at("time"), "t = 250 cs");
    EXPECT_EQ(state.at("rows")[0], 50);
    EXPECT_EQ(state.at("controls"), nlohmann::json::array());
  }
  EXPECT_EQ(run.at("print").at("printed").at("width"), 688);
  EXPECT_EQ(run.at("print").at("after").at("time"), "t = 200 cs") << "where the reader had been";
}

TEST_F(FilmInBrowser, FitsThePageAsItsOtherFiguresDo) {
  for (const bool dark : {false, true}) {
    const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", dark);
    for (const nlohmann::json& page : {run.phone, run.desk}) {
      EXPECT_EQ(page.at("scripts"), 1);
      EXPECT_LE(page.at("scroll_width"), page.at("width"));
      EXPECT_EQ(page.at("cut_figures"), 0);
      EXPECT_GE(page.at("lowest_label"), 8);
      EXPECT_EQ(page.at("texts_outside"), nlohmann::json::array());
      EXPECT_EQ(page.at("texts_overlapping"), nlohmann::json::array());
      EXPECT_GE(page.at("text_contrast"), 4.5);
      EXPECT_EQ(page.at("repeated_ids"), 0);
      EXPECT_EQ(page.at("broken_links"), 0);
      EXPECT_EQ(page.at("figure_numbers"), (nlohmann::json{1, 2, 3}));
    }
  }
}

TEST_F(FilmInBrowser, IsSeenWhereItsPanelsAreOutOfStep) {
  replace("% var(--row)\"></div>\n</div>\n<div class=\"film-panel\">",
          "% 7%\"></div>\n</div>\n<div class=\"film-panel\">");
  EXPECT_EQ(faults(measured().at("desk").at("poster")),
            (Faults{"The panels show different moments.", "The panels show different moments."}));
}

TEST_F(FilmInBrowser, IsSeenWhereItsCursorIsOffTheAxis) {
  replace("class=\"film-cursor\" x1=\"", "class=\"film-cursor\" transform=\"translate(4)\" x1=\"");
  const nlohmann::json run = measured();
  for (const char* width : {"desk", "phone"})
    EXPECT_EQ(faults(run.at(width).at("poster")),
              (Faults{"The cursor is not at its time on the axis."}));
}

TEST_F(FilmInBrowser, IsSeenWhereItsPanelsLeaveThePageOrTheScriptIsNotAllowed) {
  replace("minmax(0, var(--cell))", "500px");
  replace("minmax(0, var(--cell))", "500px");
  replace("const msPerFrame = 120", "const msPerFrame = 121");
  const MeasuredPage run = measure_in_browser(
      scratch_.path(),
      "<iframe src=report/index.html style='width:390px'></iframe><pre "
      "id=\"measures\"></pre><script>"
      "addEventListener('load', () => measures.textContent = JSON.stringify("
      "document.querySelector('iframe').contentDocument.documentElement.scrollWidth))</script>",
      false);
  EXPECT_GT(run.measures.get<double>(), 390);
  EXPECT_NE(run.log.find("CONSOLE"), std::string::npos);
}

TEST_F(FilmInBrowser, KeepsAPageOfManySolversLight) {
  Report report = sample_report();
  report.sections[1].figures.clear();
  for (int i = 0; i < 6; ++i)
    report.sections[1].figures.push_back(heavy_figure("heavy-" + std::to_string(i)));
  report.sections[1].fields = {sloshing_film("film", 60, 4, 0.006)};
  write_report(report, scratch_ / "report");
  EXPECT_LT(std::filesystem::file_size(scratch_ / "report/index.html"), 1'500'000);
  const nlohmann::json run = measured();
  EXPECT_EQ(faults(run.at("phone").at("poster")), Faults{});
  EXPECT_EQ(faults(run.at("desk").at("poster")), Faults{});
  EXPECT_EQ(run.at("desk").at("poster").at("panels").size(), 4);
}

}  // namespace
}  // namespace slosh::reports::film_browser_test
