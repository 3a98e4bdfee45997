#include "reports/write_markdown.hpp"

#include <kainjow/mustache.hpp>

#include "reports/templates.hpp"
#include "reports/text_markup.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

mustache::data cell_data(const std::string& cell) {
  const std::string sign = verdict_sign(cell_verdict(cell));
  return mustache::data{"text",
                        sign.empty() ? markdown_text(cell) : sign + " " + markdown_text(cell)};
}

mustache::data cells_data(const std::vector<std::string>& cells) {
  mustache::data list(mustache::data::type::list);
  for (const std::string& cell : cells) list << cell_data(cell);
  return list;
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

mustache::data sections_data(const Report& report) {
  mustache::data sections(mustache::data::type::list);
  int table_number = 0, figure_number = 0;
  for (const Section& section : report.sections) {
    mustache::data paragraphs(mustache::data::type::list), tables(mustache::data::type::list),
        figures(mustache::data::type::list);
    for (const std::string& text : section.paragraphs)
      paragraphs << mustache::data{"text", markdown_text(text)};
    for (const Table& table : section.tables) {
      mustache::data data = heading_data(table.id, table.title, table.caption, ++table_number);
      mustache::data rows(mustache::data::type::list);
      for (const auto& row : table.rows) rows << mustache::data{"cells", cells_data(row)};
      data.set("header", cells_data(table.header));
      data.set("rows", rows);
      tables << data;
    }
    const auto add_figure = [&](const auto& figure, const std::string& file_ending) {
      mustache::data data = heading_data(figure.id, figure.title, figure.caption, ++figure_number);
      data.set("file", figure.id + file_ending);
      figures << data;
    };
    for (const Figure& figure : section.figures) add_figure(figure, ".svg");
    for (const FieldFigure& figure : section.fields) add_figure(figure, ".png");
    mustache::data data = heading_data(section.id, section.title, "", 0);
    data.set("paragraphs", paragraphs);
    data.set("tables", tables);
    data.set("figures", figures);
    sections << data;
  }
  return sections;
}

}  // namespace

std::string markdown_page(const Report& report) {
  mustache::mustache page(markdown_template);
  mustache::data data;
  data.set("title", markdown_text(report.title));
  data.set("subtitle", markdown_text(report.subtitle));
  data.set("verdict", markdown_text(report.verdict));
  data.set("outcome", report.outcome == Outcome::pass   ? "✓ PASS"
                      : report.outcome == Outcome::fail ? "✗ FAIL"
                                                        : "? INCONCLUSIVE");
  data.set("sections", sections_data(report));
  return page.render(data);
}

}  // namespace slosh::reports
