#include "reports/tests/headless_browser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/process.hpp>
#include <cctype>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "reports/model/report_files.hpp"

namespace slosh::reports {
namespace {

namespace fs = std::filesystem;
namespace process = boost::process;

// Shows a page in a frame of a phone's width and in one of a desktop's, and writes the measurements
// as text 60 frames after both are loaded. A third frame, whose document stays open until then,
// holds this page's load event back. Contrasts are those of WCAG 2.1, against the page's own
// background.
constexpr const char* measuring_page = R"(<!DOCTYPE html><title>measure</title>
<iframe class="measured" src="PAGE" style="width:390px;height:844px;border:0"></iframe>
<iframe class="measured" src="PAGE" style="width:1280px;height:800px;border:0"></iframe>
<iframe id="until_measured"></iframe>
<pre id="measures"></pre>
<script>
const luminance = colour => {
  const [r, g, b] = colour.match(/[\d.]+/g).map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};
// A rectangle in the page, whole pixels.
const box = element => {
  const {left, top, right, bottom} = element.getBoundingClientRect();
  return {left: Math.round(left), top: Math.round(top), right: Math.round(right), bottom: Math.round(bottom)};
};
const measure = frame => {
  const page = frame.contentDocument, all = query => [...page.querySelectorAll(query)];
  const style = element => frame.contentWindow.getComputedStyle(element);
  const background = style(page.body).backgroundColor;
  const lowest = values => Math.min(100, ...values);
  const ids = all('[id]').map(element => element.id);
  return {
    width: page.documentElement.clientWidth,
    scroll_width: page.documentElement.scrollWidth,
    tables: all('table').length,
    captions: all('table > caption').length,
    headers_without_scope: all('th:not([scope])').length,
    figures: all('figure > figcaption').length,
    drawings: all('figure svg[role=img] > title').length,
    smallest_drawing: lowest(all('figure svg').map(svg => Math.min(svg.getBoundingClientRect().width, svg.getBoundingClientRect().height))),
    pictures: all('figure img').filter(picture => picture.alt.length > 20 && picture.naturalWidth > 0 && picture.naturalWidth == picture.getAttribute('width') && picture.naturalHeight == picture.getAttribute('height')).length,
    drawn_curves: all('svg [id*=gnuplot_plot] path').filter(path => path.getTotalLength() > 60).length,
    text_contrast: lowest(all('svg text').map(text => contrast(style(text).fill, background))),
    curve_contrast: lowest(all('svg [id*=gnuplot_plot] path').filter(p => style(p).stroke !== 'none').map(p => contrast(style(p).stroke, background))),
    page_contrast: lowest(all('h1, p, th, td, figcaption, .detail, a').map(element => contrast(style(element).color, background))),
    heading_levels: all('h1, h2, h3, h4, h5, h6').map(heading => +heading.tagName[1]),
    first_focus: all('a[href], button, input, [tabindex="0"]')[0]?.className ?? '',
    landmarks: ['header', 'main', 'footer'].filter(name => all('body > ' + name).length == 1).length,
    unnamed_landmarks: all('nav:not([aria-label], [aria-labelledby]), section:not([aria-labelledby])').length,
    links: all('a[href]').map(a => a.getAttribute('href')).filter(address => !address.startsWith('#')),
    height: frame.clientHeight,
    decision: all('.decision')[0]?.textContent ?? '',
    // Small multiples: the card, its drawing, and the smallest text as shown.
    glances: all('.glances li').filter(card => card.querySelector('svg')).map(card => ({
      card: box(card), drawing: box(card.querySelector('svg')), verdict: card.querySelector('.standing')?.textContent ?? '',
      leads_to: card.querySelector('a.glance')?.getAttribute('href') ?? '',
      smallest_text: Math.min(...[...card.querySelectorAll('svg text')].map(text => text.getBoundingClientRect().height)),
      colours: [...new Set([...card.querySelectorAll('svg [id*=gnuplot_plot] path')].map(path => style(path).stroke))]})),
    glance_legend: all('.glance-legend > span').map(entry => entry.textContent.trim()),
    legend_colours: all('.glance-legend path').map(path => style(path).stroke),
    // Shaded areas of the curves, from the left, without the legend's.
    ribbons: all('figure svg polygon').filter(area => Number(style(area).fillOpacity) < 1).map(box).filter(area => area.right - area.left > 60).sort((a, b) => a.left - b.left),
    // Texts of a drawing that lie on one another, by more than two pixels.
    texts_overlapping: all('svg.plot').flatMap(svg => {
      const texts = [...svg.querySelectorAll('text')].map(text => ({name: text.textContent, at: text.getBoundingClientRect()}));
      return texts.flatMap((one, i) => texts.slice(i + 1).filter(other => one.at.left < other.at.right - 2 && other.at.left < one.at.right - 2 && one.at.top < other.at.bottom - 2 && other.at.top < one.at.bottom - 2).map(other => one.name + ' / ' + other.name));
    }),
    // Texts that leave their drawing, where they would be cut off.
    texts_outside: all('svg.plot text').filter(text => {
      const inner = text.getBoundingClientRect(), outer = text.ownerSVGElement.getBoundingClientRect();
      return inner.left < outer.left - 1 || inner.right > outer.right + 1 || inner.top < outer.top - 1 || inner.bottom > outer.bottom + 1;
    }).map(text => text.textContent),
    dark: luminance(background) < 0.2,
    verdict_first: all('h1, h2, p, table')[1]?.className.startsWith('verdict') ?? false,
    table_rows: Object.fromEntries(all('table').map(table => [table.id, table.querySelectorAll('tbody tr').length])),
    verdict: all('.verdict')[0]?.textContent ?? '',
    repeated_ids: ids.length - new Set(ids).size,
    broken_links: all('a[href^="#"], use').filter(a => !page.getElementById(a.getAttribute('href').slice(1))).length,
    scripts: all('script').length,
    wide_boxes: all('.scroll').filter(box => box.scrollWidth > box.clientWidth).length,
    unhinted_boxes: all('.scroll').filter(box => (box.scrollWidth > box.clientWidth) != (box.querySelector('.hint').getBoundingClientRect().height > 10)).length,
    cut_figures: all('figure svg, figure img').filter(part => !part.closest('.scroll')).filter(part => part.getBoundingClientRect().left < 0 || part.getBoundingClientRect().right > page.documentElement.clientWidth).length,
    lowest_label: lowest(all('figure svg text').map(text => text.getBoundingClientRect().height)),
    figure_numbers: all('figcaption b').map(text => +text.textContent.match(/^Figure (\d+)\./)[1]),
    table_numbers: all('caption b').map(text => +text.textContent.match(/^Table (\d+)\./)[1]),
    folded_reasons: all('.reason').filter(reason => !reason.open).length,
    weight: page.documentElement.outerHTML.length,
  };
};
const frames = [...document.querySelectorAll('.measured')], last = document.getElementById('until_measured');
last.contentDocument.open();
const write = () => {
  document.getElementById('measures').textContent = JSON.stringify(frames.map(measure));
  last.contentDocument.close();
};
// A hint follows its box's scroll timeline, which a busy machine gives its state some frames after the load.
const after = (count, action) => count ? requestAnimationFrame(() => after(count - 1, action)) : action();
// A busy machine may have loaded a frame before it comes here.
const is_loaded = frame => frame.contentDocument.readyState == 'complete' && frame.contentWindow.location.href != 'about:blank';
Promise.all(frames.map(frame => is_loaded(frame) || new Promise(loaded => frame.addEventListener('load', loaded)))).then(() => {
  // Nothing is laid out in what is folded.
  frames.forEach(frame => frame.contentDocument.querySelectorAll('.folded').forEach(part => part.open = true));
  after(60, write);
});
</script>)";

// RFC 8089, percent-encoded.
std::string file_url(const fs::path& file) {
  std::string url = "file://";
  for (const char c : file.string())
    url += std::isalnum(static_cast<unsigned char>(c)) || c == '/' || c == '.' || c == '-'
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return url;
}

// Throws std::runtime_error if the browser does not end within a minute.
void run_browser(const fs::path& directory, std::vector<std::string> arguments,
                 const fs::path& page) {
  const fs::path log = directory / "browser.log";
  for (const char* argument :
       {"--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
        "--no-first-run", "--disable-component-update", "--disable-sync"})
    arguments.push_back(argument);
  arguments.push_back("--user-data-dir=" + (directory / "profile").string());
  arguments.push_back(file_url(page));
  process::group group;
  process::child browser(
      process::search_path("chromium"), process::args(arguments),
      process::std_in<process::null, process::std_out>(directory / "dom.html").string(),
      process::std_err > log.string(), group);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (browser.running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (std::chrono::steady_clock::now() < deadline) continue;
    group.terminate();
    throw std::runtime_error("chromium did not answer within 60 s: " + read_text(log));
  }
}

}  // namespace

bool browser_is_installed() { return !process::search_path("chromium").empty(); }

BrowserRun open_in_browser(const fs::path& directory, const std::string& page, bool dark) {
  write_text(directory / "measure.html",
             boost::replace_all_copy(std::string(measuring_page), "PAGE", page));
  run_browser(
      directory,
      {"--enable-logging=stderr", "--allow-file-access-from-files", "--window-size=1800,900",
       "--hide-scrollbars",
       dark ? "--blink-settings=preferredColorScheme=0" : "--blink-settings=preferredColorScheme=1",
       "--dump-dom"},
      directory / "measure.html");
  const std::string dom = read_text(directory / "dom.html"), opening = "<pre id=\"measures\">";
  const auto start = dom.find(opening), end = dom.find("</pre>");
  if (start == std::string::npos || end == std::string::npos)
    throw std::runtime_error("no measures in: " + dom);
  std::string measures = dom.substr(start + opening.size(), end - start - opening.size());
  for (const auto& [entity, sign] :
       {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&amp;", "&"}})
    boost::replace_all(measures, entity, sign);
  const nlohmann::json both = nlohmann::json::parse(measures);
  return {both.at(0), both.at(1), read_text(directory / "browser.log")};
}

bool in_order(const std::vector<int>& levels) {
  int last = 0;
  for (const int level : levels) {
    if (level > last + 1) return false;
    last = level;
  }
  return !levels.empty() && levels[0] == 1 && std::count(levels.begin(), levels.end(), 1) == 1;
}

std::vector<std::string> faults_of(const BrowserRun& run) {
  std::vector<std::string> faults;
  if (run.log.find("CONSOLE") != std::string::npos) faults.push_back("log");
  for (const nlohmann::json* page : {&run.phone, &run.desk}) {
    const auto number = [&](const char* name) { return page->at(name).get<double>(); };
    const auto require = [&](bool holds, const char* name) {
      if (!holds) faults.push_back(std::string(name) + ": " + page->at(name).dump());
    };
    for (const char* none : {"headers_without_scope", "unnamed_landmarks", "repeated_ids",
                             "broken_links", "scripts", "cut_figures", "unhinted_boxes"})
      require(number(none) == 0, none);
    for (const char* none : {"texts_outside", "texts_overlapping"})
      require(page->at(none).empty(), none);
    for (const auto& [measure, lowest] : {std::pair{"text_contrast", 4.5},
                                          {"page_contrast", 4.5},   // WCAG 2.1, 1.4.3
                                          {"curve_contrast", 3.0},  // WCAG 2.1, 1.4.11
                                          {"lowest_label", 11.0},
                                          {"smallest_drawing", 100.0}})  // px
      require(number(measure) >= lowest, measure);
    require(number("scroll_width") <= number("width"), "scroll_width");
    require(number("captions") == number("tables"), "captions");
    require(number("drawings") + number("pictures") == number("figures"), "figures");
    require(page->at("first_focus") == "skip", "first_focus");
    require(number("landmarks") == 3, "landmarks");
    require(in_order(page->at("heading_levels")), "heading_levels");
  }
  return faults;
}

}  // namespace slosh::reports
