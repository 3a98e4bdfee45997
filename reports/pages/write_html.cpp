#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "reports/drawing/figure_palette.hpp"
#include "reports/pages/glance_markup.hpp"
#include "reports/pages/page_links.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/text_markup.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

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
