#include "reports/write_html.hpp"

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "reports/figure_palette.hpp"
#include "reports/film_markup.hpp"
#include "reports/templates.hpp"
#include "reports/text_markup.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

// Which columns hold numbers only, and at least one.
std::vector<bool> numeric_columns(const Table& table) {
  std::vector<bool> numeric;
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    numeric.push_back(!table.rows.empty() &&
                      std::all_of(table.rows.begin(), table.rows.end(),
                                  [&](const auto& row) { return is_numeric(row[column]); }));
  }
  return numeric;
}

const char* cell_class(CellVerdict verdict, bool numeric) {
  switch (verdict) {
    case CellVerdict::good:
      return "good";
    case CellVerdict::bad:
      return "bad";
    case CellVerdict::neutral:
      return "neutral";
    case CellVerdict::none:
      break;
  }
  return numeric ? "number" : "text";
}

mustache::data cell_data(const std::string& cell, bool numeric) {
  const CellVerdict verdict = cell_verdict(cell);
  mustache::data data;
  data.set("class", cell_class(verdict, numeric));
  data.set("sign", verdict_sign(verdict));
  data.set("has_sign", verdict != CellVerdict::none);
  data.set("text", html_text(cell));
  return data;
}

mustache::data table_data(const Table& table, int number) {
  const std::vector<bool> numeric = numeric_columns(table);
  mustache::data header(mustache::data::type::list), rows(mustache::data::type::list);
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    mustache::data heading{"text", html_text(table.header[i])};
    heading.set("class", numeric[i] ? "number" : "text");
    header << heading;
  }
  for (const auto& row : table.rows) {
    mustache::data cells(mustache::data::type::list);
    for (std::size_t i = 1; i < row.size(); ++i) cells << cell_data(row[i], numeric[i]);
    mustache::data line;
    if (!row.empty()) line.set("first", cell_data(row[0], numeric[0]));
    line.set("cells", cells);
    rows << line;
  }
  mustache::data data;
  data.set("id", table.id);
  data.set("number", std::to_string(number));
  data.set("title", html_text(table.title));
  data.set("caption", html_text(table.caption));
  data.set("header", header);
  data.set("rows", rows);
  return data;
}

template <typename AnyFigure>
mustache::data heading_data(const AnyFigure& figure, int number) {
  mustache::data data;
  data.set("id", figure.id);
  data.set("number", std::to_string(number));
  data.set("title", html_text(figure.title));
  data.set("caption", html_text(figure.caption));
  return data;
}

mustache::data figure_data(const Figure& figure, const DrawnFigure& drawn, int number) {
  mustache::data data = heading_data(figure, number);
  data.set("svg", svg_element(figure, drawn, SvgPlace::in_page));
  data.set("film", mustache::data(mustache::data::type::bool_false));
  return data;
}

mustache::data field_data(const FieldFigure& figure, const DrawnField& drawn, int number) {
  if (!figure.frames.empty()) {
    mustache::data data = heading_data(figure, number);
    data.set("film", film_element(figure, drawn));
    return data;
  }
  mustache::data picture;
  picture.set("width", std::to_string(drawn.width));
  picture.set("height", std::to_string(drawn.height));
  picture.set("description", description(figure));
  picture.set("address", data_address(drawn));
  mustache::data data = heading_data(figure, number);
  data.set("picture", picture);
  data.set("film", mustache::data(mustache::data::type::bool_false));
  return data;
}

mustache::data sections_data(const Report& report, const Drawings& drawings) {
  mustache::data sections(mustache::data::type::list);
  int table_number = 0, figure_number = 0;
  auto drawn_figure = drawings.figures.begin();
  auto drawn_field = drawings.fields.begin();
  for (const Section& section : report.sections) {
    mustache::data paragraphs(mustache::data::type::list), tables(mustache::data::type::list),
        figures(mustache::data::type::list);
    for (const std::string& paragraph : section.paragraphs)
      paragraphs << mustache::data{"text", html_text(paragraph)};
    for (const Table& table : section.tables) tables << table_data(table, ++table_number);
    for (const Figure& figure : section.figures)
      figures << figure_data(figure, *drawn_figure++, ++figure_number);
    for (const FieldFigure& figure : section.fields)
      figures << field_data(figure, *drawn_field++, ++figure_number);
    mustache::data data;
    data.set("id", section.id);
    data.set("title", section.title);
    data.set("paragraphs", paragraphs);
    data.set("tables", tables);
    data.set("figures", figures);
    sections << data;
  }
  return sections;
}

// The sign is hidden from screen readers, the word is not.
mustache::data outcome_data(Outcome outcome) {
  mustache::data data;
  const bool pass = outcome == Outcome::pass, fail = outcome == Outcome::fail;
  data.set("class", pass ? "good" : fail ? "bad" : "unsure");
  data.set("sign", pass ? "✓" : fail ? "✗" : "?");
  data.set("word", pass ? "Pass" : fail ? "Fail" : "Inconclusive");
  return data;
}

bool has_film(const Report& report) {
  return std::any_of(report.sections.begin(), report.sections.end(), [](const Section& section) {
    return std::any_of(section.fields.begin(), section.fields.end(),
                       [](const FieldFigure& figure) { return !figure.frames.empty(); });
  });
}

// What makes films play; nothing in a page without one.
mustache::data film_data(const Report& report) {
  if (!has_film(report)) return mustache::data(mustache::data::type::bool_false);
  mustache::data data;
  data.set("policy", film_script_policy());
  data.set("script", film_script_element());
  return data;
}

}  // namespace

std::string html_page(const Report& report, const Drawings& drawings) {
  mustache::mustache page(page_template);
  mustache::data data;
  data.set("title", report.title);
  data.set("subtitle", report.subtitle);
  data.set("verdict", html_text(report.verdict));
  data.set("outcome", outcome_data(report.outcome));
  data.set("style", page_style);
  data.set("dark_rules", dark_rules());
  data.set("film", film_data(report));
  data.set("sections", sections_data(report, drawings));
  return page.render(data);
}

}  // namespace slosh::reports
