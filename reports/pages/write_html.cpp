#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_curves.hpp"
#include "reports/model/report_model.hpp"
#include "reports/pages/page_links.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/text_markup.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

// The list of a report's pages with their verdicts, and for each the small figure of its main
// result: the report at a glance, as data of the HTML templates.

namespace mustache = kainjow::mustache;

// gnuplot's "(14,3)" as SVG's "14,3".
std::string svg_dash(const std::string& dash) {
  return dash == "solid" ? "none" : dash.substr(1, dash.size() - 2);
}

// One entry for each label of all glances.
mustache::data legend_data(const Report& report) {
  mustache::data entries(mustache::data::type::list);
  std::vector<std::string> known;
  for (const Page& page : report.pages) {
    if (!page.glance) continue;
    for (const Curve& curve : page.glance->curves) {
      if (std::find(known.begin(), known.end(), curve.label) != known.end()) continue;
      known.push_back(curve.label);
      const Stroke stroke = stroke_of(curve.look.value_or(Look{}));
      mustache::data entry{"label", html_text(curve.label)};
      entry.set("colour", stroke.colour);
      entry.set("dash", svg_dash(stroke.dash));
      entries << entry;
    }
  }
  return entries;
}

// Screen readers read the word but not the sign.
// A verdict as a class, a sign, a word and a sentence.
mustache::data outcome_data(Outcome outcome, const std::string& sentence) {
  mustache::data data;
  const auto [mark, word] = outcome_sign(outcome);
  data.set("class", outcome == Outcome::pass           ? "good"
                    : outcome == Outcome::watched      ? "watched"
                    : outcome == Outcome::inconclusive ? "unsure"
                                                       : "bad");
  data.set("sign", mark);
  data.set("word", word);
  data.set("sentence", html_text(sentence));
  return data;
}

// The entry of a page, in the list of pages and in the links of its neighbours. `glance` may be
// null.
mustache::data entry_data(const Page& page, const DrawnFigure* glance = nullptr) {
  mustache::data data;
  data.set("title", page.title);
  data.set("address", page_file(page.id));
  if (!page.verdict.empty()) data.set("outcome", outcome_data(page.outcome, page.verdict));
  if (!glance) return data;
  if (!page.remark.empty()) data.set("remark", html_text(page.remark));
  if (!page.glance) return data;
  mustache::data figure{"svg", svg_element(*page.glance, *glance, SvgPlace::in_page)};
  figure.set("shows", html_text(page.glance->caption));
  data.set("glance", figure);
  return data;
}

// All entries with their figures, and the one legend of these figures.
mustache::data glances_data(const Report& report, const Drawings& drawings) {
  mustache::data entries(mustache::data::type::list);
  for (std::size_t i = 0; i < report.pages.size(); ++i)
    if (report.pages[i].continues.empty())
      entries << entry_data(report.pages[i], &drawings.glances[i]);
  mustache::data data{"entries", entries};
  data.set("legend", legend_data(report));
  data.set("has_legend", std::any_of(report.pages.begin(), report.pages.end(),
                                     [](const Page& page) { return page.glance.has_value(); }));
  return data;
}

mustache::data sections_of(const Report& report, const std::string& page,
                           const std::vector<mustache::data>& written) {
  mustache::data sections(mustache::data::type::list);
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    if (report.sections[i].page == page) sections << written[i];
  return sections;
}

// The first page in the form of the others.
Page first_page(const Report& report) { return {"", report.title, report.verdict, report.outcome}; }

mustache::data document_data(const Report& report) {
  mustache::data data;
  data.set("report_title", report.title);
  data.set("subtitle", report.subtitle);
  data.set("style", page_style);
  data.set("dark_rules", dark_rules());
  data.set("sections_part", mustache::partial([] { return sections_template; }));
  data.set("glances_part", mustache::partial([] { return glances_template; }));
  data.set("banner_part", mustache::partial([] { return banner_template; }));
  data.set("cell_part", mustache::partial([] { return cell_template; }));
  return data;
}

// The verdict at the top of a page. The first page's verdict names what decides it.
mustache::data banner_data(const Report& report, const Page& page, const PageLinks& links) {
  mustache::data data = outcome_data(page.outcome, page.verdict);
  const auto& [lead, decides, finding] = report.decision;
  if (!page.id.empty() || decides.text.empty()) return data;
  mustache::data decision{"lead", html_text(lead)};
  decision.set("text", html_text(decides.text));
  decision.set("address", links.to_anchor(decides.anchor, page.id));
  if (!finding.empty()) decision.set("finding", html_text(finding));
  data.set("decision", decision);
  return data;
}

// The pages that continue this one.
std::vector<Page> continuing(const Report& report, const std::string& id) {
  std::vector<Page> found;
  for (const Page& page : report.pages)
    if (page.continues == id) found.push_back(page);
  return found;
}

mustache::data list_of(const std::vector<Page>& pages) {
  mustache::data list(mustache::data::type::list);
  for (const Page& page : pages) list << entry_data(page);
  return list;
}

mustache::data page_data(const Report& report, const Page& page, const PageLinks& links,
                         const std::vector<mustache::data>& written) {
  mustache::data data;
  data.set("title", page.title);
  if (page.id.empty() && !report.coverage.empty()) data.set("coverage", html_text(report.coverage));
  if (!page.verdict.empty()) data.set("outcome", banner_data(report, page, links));
  mustache::data doubts(mustache::data::type::list);
  for (const std::string& one : page.id.empty() ? report.doubts : page.doubts)
    doubts << mustache::data{"doubt", html_text(one)};
  data.set("doubts", doubts);
  data.set("sections", sections_of(report, page.id, written));
  if (!page.id.empty()) data.set("appendices", list_of(continuing(report, page.id)));
  return data;
}

std::string figure_page_style() {
  return fmt::format(
      "body{{font-family:system-ui,sans-serif;max-width:800px;margin:2rem auto;padding:0 1rem;"
      "background:{};color:{}}}svg{{max-width:100%;height:auto}}figure{{margin:0 0 2rem}}"
      "@media (prefers-color-scheme: dark){{body{{background:{};color:{}}}\n{}}}",
      paper.light, ink.light, paper.dark, ink.dark, dark_rules());
}

}  // namespace

std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings) {
  const PageLinks links(report);
  const std::vector<mustache::data> written = sections_data(report, drawings);
  std::vector<Page> pages{first_page(report)};
  pages.insert(pages.end(), report.pages.begin(), report.pages.end());
  std::vector<HtmlFile> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    mustache::data data = document_data(report);
    data.set("page", page_data(report, pages[i], links, written));
    data.set("is_first", i == 0);
    data.set("has_pages", i == 0 && pages.size() > 1);
    data.set("has_neighbours", pages.size() > 1);
    if (i == 0) data.set("glances", glances_data(report, drawings));
    if (i > 0) data.set("previous", entry_data(pages[i - 1]));
    if (i + 1 < pages.size()) data.set("next", entry_data(pages[i + 1]));
    mustache::mustache page(page_template);
    files.push_back({page_file(pages[i].id), page.render(data)});
  }
  return files;
}

std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n<h1>{0}</h1>\n",
      html_text(title), figure_page_style());
  for (const Figure& figure : figures)
    page +=
        fmt::format("<figure>\n<h2>{}</h2>\n{}<figcaption>{}</figcaption>\n</figure>\n",
                    html_text(figure.title),
                    svg_element(figure, draw_figure(figure, scratch_directory), SvgPlace::in_page),
                    html_text(figure.caption));
  for (const std::string& remark : remarks) page += "<p>" + html_text(remark) + "</p>\n";
  return page + "</html>\n";
}

}  // namespace slosh::reports
