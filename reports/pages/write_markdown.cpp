#include <fmt/format.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <kainjow/mustache.hpp>
#include <map>
#include <vector>

#include "reports/pages/report_documents.hpp"
#include "reports/pages/text_markup.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

mustache::data cell_data(const std::string& cell, const std::string& anchor = "") {
  const std::string sign = verdict_sign(cell_verdict(cell));
  const std::string text = (sign.empty() ? "" : sign + " ") + markdown_text(cell);
  return mustache::data{"text", anchor.empty() ? text : fmt::format("[{}](#{})", text, anchor)};
}

mustache::data header_data(const Table& table) {
  mustache::data list(mustache::data::type::list);
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    if (i + 1 == table.header.size() && !table.trends.empty()) list << cell_data("trend");
    list << cell_data(table.header[i]);
  }
  if (!table.reasons.empty()) list << cell_data("reason");
  return list;
}

mustache::data row_data(const Table& table, std::size_t row) {
  mustache::data cells(mustache::data::type::list);
  for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
    if (i + 1 == table.rows[row].size() && !table.trends.empty())
      cells << cell_data(table.trends[row].text);
    cells << cell_data(table.rows[row][i], table.links.empty() ? "" : table.links[row][i]);
  }
  if (!table.reasons.empty()) cells << mustache::data{"text", markdown_text(table.reasons[row])};
  mustache::data data{"cells", cells};
  data.set("anchor",
           table.row_ids.empty() ? "" : fmt::format("<a id=\"row-{}\"></a>", table.row_ids[row]));
  return data;
}

mustache::data heading_data(const std::string& id, const std::string& title,
                            const std::string& caption, int number) {
  mustache::data data;
  data.set("id", id);
  data.set("number", std::to_string(number));
  data.set("title", markdown_text(title));
  data.set("caption", markdown_text(caption));
  return data;
}

mustache::data section_data(const Section& section, const char* marks, Numbers& numbers) {
  mustache::data paragraphs(mustache::data::type::list), tables(mustache::data::type::list),
      figures(mustache::data::type::list);
  for (const std::string& text : section.paragraphs)
    paragraphs << mustache::data{"text", markdown_text(text)};
  for (const Table& table : section.tables) {
    mustache::data data = heading_data(table.id, table.title, table.caption, ++numbers.table);
    mustache::data rows(mustache::data::type::list);
    for (std::size_t row = 0; row < table.rows.size(); ++row) rows << row_data(table, row);
    data.set("header", header_data(table));
    data.set("rows", rows);
    tables << data;
  }
  const auto add_figure = [&](const auto& figure, const std::string& file_ending) {
    mustache::data data = heading_data(figure.id, figure.title, figure.caption, ++numbers.figure);
    data.set("file", figure.id + file_ending);
    figures << data;
  };
  for (const Figure& figure : section.figures) add_figure(figure, ".svg");
  for (const FieldFigure& figure : section.fields) add_figure(figure, ".png");
  mustache::data data = heading_data(section.id, section.title, "", 0);
  data.set("marks", marks);
  data.set("paragraphs", paragraphs);
  data.set("tables", tables);
  data.set("figures", figures);
  return data;
}

std::string standing_text(Outcome outcome, const std::string& verdict) {
  if (verdict.empty()) return "";
  const auto [mark, word] = outcome_sign(outcome);
  return fmt::format("**{} {}** {}", mark, boost::to_upper_copy(word), markdown_text(verdict));
}

std::string decision_text(const Decision& decision) {
  const auto& [lead, row, finding] = decision;
  if (row.text.empty()) return "";
  return fmt::format(" {} [{}](#{}){}", markdown_text(lead), markdown_text(row.text), row.anchor,
                     finding.empty() ? "." : ": " + markdown_text(finding));
}

// Returns the first page, then the others, each with its sections.
mustache::data pages_data(const Report& report) {
  std::vector<Page> pages{{"", report.title, "", {}}};
  pages.insert(pages.end(), report.pages.begin(), report.pages.end());
  std::vector<mustache::data> written;
  std::map<std::string, Numbers> numbers;
  for (const Section& section : report.sections)
    written.push_back(
        section_data(section, section.page.empty() ? "##" : "###", numbers[section.page]));
  mustache::data list(mustache::data::type::list);
  for (const Page& page : pages) {
    mustache::data sections(mustache::data::type::list);
    for (std::size_t i = 0; i < report.sections.size(); ++i)
      if (report.sections[i].page == page.id) sections << written[i];
    mustache::data data = heading_data(page.id, page.title, "", 0);
    data.set("is_first", page.id.empty());
    data.set("standing", standing_text(page.outcome, page.verdict));
    data.set("sections", sections);
    list << data;
  }
  return list;
}

mustache::data contents_data(const Report& report) {
  mustache::data list(mustache::data::type::list);
  const auto add = [&](const std::string& title, const std::string& anchor,
                       const std::string& standing) {
    list << mustache::data{"entry", fmt::format("[{}](#{}){}{}", markdown_text(title), anchor,
                                                standing.empty() ? "" : " ", standing)};
  };
  for (const Section& section : report.sections)
    if (section.page.empty()) add(section.title, "section-" + section.id, "");
  for (const Page& page : report.pages) {
    const std::string picture =
        page.glance ? fmt::format(" ![{}](figures/{}.svg)", markdown_text(page.glance->title),
                                  page.glance->id)
                    : "";
    const std::string remark = page.remark.empty() ? "" : " " + markdown_text(page.remark);
    add(page.title, "page-" + page.id,
        standing_text(page.outcome, page.verdict) + remark + picture);
  }
  return list;
}

}  // namespace

std::string markdown_page(const Report& report) {
  mustache::mustache page(markdown_template);
  mustache::data data;
  data.set("title", markdown_text(report.title));
  data.set("subtitle", markdown_text(report.subtitle));
  data.set("standing",
           standing_text(report.outcome, report.verdict) + decision_text(report.decision));
  if (!report.coverage.empty()) data.set("coverage", markdown_text(report.coverage));
  data.set("contents", contents_data(report));
  data.set("pages", pages_data(report));
  return page.render(data);
}

}  // namespace slosh::reports
