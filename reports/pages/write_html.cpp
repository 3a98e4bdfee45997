#include "reports/pages/write_html.hpp"

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "reports/drawing/figure_palette.hpp"
#include "reports/fields/film_markup.hpp"
#include "reports/pages/text_markup.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

// The sign is hidden from screen readers, the word is not.
mustache::data outcome_data(Outcome outcome, const std::string& sentence) {
  mustache::data data;
  const auto [mark, word] = outcome_sign(outcome);
  data.set("class", outcome == Outcome::pass           ? "good"
                    : outcome == Outcome::inconclusive ? "unsure"
                                                       : "bad");
  data.set("sign", mark);
  data.set("word", word);
  data.set("sentence", html_text(sentence));
  return data;
}

// What lists and neighbours tell of a page.
mustache::data entry_data(const Page& page, const PageLinks& links) {
  mustache::data data;
  data.set("title", page.title);
  data.set("address", links.to_page(page.id));
  if (!page.verdict.empty()) data.set("outcome", outcome_data(page.outcome, page.verdict));
  return data;
}

mustache::data sections_of(const Report& report, const std::string& page,
                           const std::vector<mustache::data>& written) {
  mustache::data sections(mustache::data::type::list);
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    if (report.sections[i].page == page) sections << written[i];
  return sections;
}

// The first page as one among the others.
Page first_page(const Report& report) { return {"", report.title, report.verdict, report.outcome}; }

mustache::data document_data(const Report& report) {
  mustache::data data;
  data.set("page_mark", page_mark);
  data.set("report_title", report.title);
  data.set("subtitle", report.subtitle);
  data.set("style", page_style);
  data.set("dark_rules", dark_rules());
  data.set("sections_part", mustache::partial([] { return sections_template; }));
  data.set("cell_part", mustache::partial([] { return cell_template; }));
  return data;
}

// The verdict that a page begins with; the first page's names the row that decides it.
mustache::data banner_data(const Report& report, const Page& page, const PageLinks& links) {
  mustache::data data = outcome_data(page.outcome, page.verdict);
  if (!page.id.empty() || report.decided_by.text.empty()) return data;
  mustache::data row;
  row.set("text", html_text(report.decided_by.text));
  row.set("address", links.to_anchor(report.decided_by.anchor, page.id));
  data.set("decided_by", row);
  return data;
}

mustache::data page_data(const Report& report, const Page& page, const PageLinks& links,
                         const std::vector<mustache::data>& written) {
  mustache::data data;
  data.set("id", page.id);
  data.set("title", page.title);
  if (!page.verdict.empty()) data.set("outcome", banner_data(report, page, links));
  data.set("sections", sections_of(report, page.id, written));
  return data;
}

mustache::data list_of(const std::vector<Page>& pages, const PageLinks& links) {
  mustache::data list(mustache::data::type::list);
  for (const Page& page : pages) list << entry_data(page, links);
  return list;
}

bool has_film(const Report& report, const std::string& page) {
  return std::any_of(report.sections.begin(), report.sections.end(), [&](const Section& section) {
    return section.page == page &&
           std::any_of(section.fields.begin(), section.fields.end(),
                       [](const FieldFigure& figure) { return !figure.frames.empty(); });
  });
}

// What makes films play; nothing in a page without one.
mustache::data film_data(const Report& report, const std::string& page) {
  if (!has_film(report, page)) return mustache::data(mustache::data::type::bool_false);
  mustache::data data;
  data.set("policy", film_script_policy());
  data.set("script", film_script_element());
  return data;
}

}  // namespace

std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings) {
  const PageLinks links(report, Layout::pages);
  const std::vector<mustache::data> written = sections_data(report, drawings, Layout::pages);
  std::vector<Page> pages{first_page(report)};
  pages.insert(pages.end(), report.pages.begin(), report.pages.end());
  std::vector<HtmlFile> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    mustache::data data = document_data(report);
    data.set("page", page_data(report, pages[i], links, written));
    data.set("film", film_data(report, pages[i].id));
    data.set("is_first", i == 0);
    data.set("has_pages", i == 0 && pages.size() > 1);
    data.set("has_neighbours", pages.size() > 1);
    if (i == 0) data.set("pages", list_of(report.pages, links));
    if (i > 0) data.set("previous", entry_data(pages[i - 1], links));
    if (i + 1 < pages.size()) data.set("next", entry_data(pages[i + 1], links));
    mustache::mustache page(page_template);
    files.push_back({page_file(pages[i].id), page.render(data)});
  }
  return files;
}

std::string whole_document(const Report& report, const Drawings& drawings) {
  const PageLinks links(report, Layout::whole);
  const std::vector<mustache::data> written = sections_data(report, drawings, Layout::whole);
  mustache::data data = document_data(report), pages(mustache::data::type::list);
  for (const Page& page : report.pages) pages << page_data(report, page, links, written);
  data.set("first", page_data(report, first_page(report), links, written));
  data.set("contents", list_of(report.pages, links));
  data.set("pages", pages);
  mustache::mustache document(whole_template);
  return document.render(data);
}

}  // namespace slosh::reports
