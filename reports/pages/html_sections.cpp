#include <algorithm>
#include <map>

#include "reports/model/report_files.hpp"
#include "reports/pages/page_links.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/text_markup.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

// Tells which columns hold numbers only; a table without rows has none.
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
  static constexpr const char* classes[]{"text", "good", "bad", "unsure", "neutral"};
  return verdict == CellVerdict::none && numeric ? "number"
                                                 : classes[static_cast<std::size_t>(verdict)];
}

// The verdict's word is separate from the text after it. `address` is empty for no link.
mustache::data cell_data(const std::string& cell, bool numeric, const std::string& address) {
  const CellVerdict verdict = cell_verdict(cell);
  const bool has_sign = verdict != CellVerdict::none;
  const std::size_t word = has_sign ? cell.find(": ") : std::string::npos;
  mustache::data data;
  data.set("class", cell_class(verdict, numeric));
  data.set("sign", verdict_sign(verdict));
  data.set("has_sign", has_sign);
  data.set("text", html_text(cell.substr(0, word)));
  data.set("has_rest", word != std::string::npos);
  data.set("rest", word == std::string::npos ? "" : html_text(cell.substr(word + 2)));
  data.set("is_link", !address.empty());
  data.set("address", address);
  return data;
}

constexpr std::size_t most_rows = 100;

// The numbers of a page's last table and figure.
struct Numbers {
  int table = 0, figure = 0;
};

class SectionWriter {
 public:
  SectionWriter(const Report& report, const Drawings& drawings)
      : links_(report),
        drawn_figure_(drawings.figures.begin()),
        drawn_field_(drawings.fields.begin()) {}

  // Must be called once for each section, in the report's order.
  mustache::data operator()(const Section& section) {
    mustache::data paragraphs(mustache::data::type::list), tables(mustache::data::type::list),
        figures(mustache::data::type::list);
    for (const std::string& paragraph : section.paragraphs)
      paragraphs << mustache::data{"text", html_text(paragraph)};
    for (const Table& table : section.tables) tables << table_data(table, section.page);
    for (const Figure& figure : section.figures) figures << figure_data(figure, section.page);
    for (const FieldFigure& figure : section.fields) figures << field_data(figure, section.page);
    mustache::data data;
    data.set("id", section.id);
    data.set("title", section.title);
    data.set("paragraphs", paragraphs);
    data.set("tables", tables);
    data.set("figures", figures);
    data.set("has_figures", section.figures.size() + section.fields.size() > 0);
    data.set("has_parts",
             section.tables.size() + section.figures.size() + section.fields.size() > 1);
    return data;
  }

 private:
  mustache::data row_data(const Table& table, std::size_t row, const std::vector<bool>& numeric,
                          const std::string& page) const {
    const std::vector<std::string>& cells = table.rows[row];
    const std::string reason = table.reasons.empty() ? "" : table.reasons[row];
    const auto cell = [&](std::size_t i) {
      const std::string anchor = table.links.empty() ? "" : table.links[row][i];
      return cell_data(cells[i], numeric[i], anchor.empty() ? "" : links_.to_anchor(anchor, page));
    };
    mustache::data others(mustache::data::type::list);
    for (std::size_t i = 1; i < cells.size(); ++i) {
      mustache::data other = cell(i);
      const bool has_reason = i + 1 == cells.size() && !reason.empty();
      other.set("has_reason", has_reason);
      if (has_reason) other.set("reason", html_text(reason));
      others << other;
    }
    mustache::data line;
    line.set("has_id", !table.row_ids.empty());
    line.set("row_id", table.row_ids.empty() ? "" : table.row_ids[row]);
    if (!cells.empty()) line.set("first", cell(0));
    line.set("cells", others);
    return line;
  }

  mustache::data table_data(const Table& table, const std::string& page) {
    const std::vector<bool> numeric = numeric_columns(table);
    mustache::data header(mustache::data::type::list), rows(mustache::data::type::list);
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      mustache::data heading{"text", html_text(table.header[i])};
      heading.set("class", numeric[i] ? "number" : "text");
      header << heading;
    }
    const std::size_t shown = rows_on_page(table);
    for (std::size_t row = 0; row < shown; ++row) rows << row_data(table, row, numeric, page);
    mustache::data data = caption_data(table, ++numbers_[page].table);
    if (shown < table.rows.size()) {
      mustache::data cut;
      cut.set("shown", std::to_string(shown));
      cut.set("all", std::to_string(table.rows.size()));
      cut.set("address", table_file(table));
      data.set("cut", cut);
    } else {
      data.set("cut", mustache::data(mustache::data::type::bool_false));
    }
    data.set("header", header);
    data.set("rows", rows);
    data.set("is_folded", table.is_folded);
    data.set("rows_count", std::to_string(table.rows.size()));
    return data;
  }

  template <typename Captioned>
  static mustache::data caption_data(const Captioned& part, int number) {
    mustache::data data;
    data.set("id", part.id);
    data.set("number", std::to_string(number));
    data.set("title", html_text(part.title));
    data.set("caption", html_text(part.caption));
    return data;
  }

  // On a page a picture links to the file that holds all its detail.
  mustache::data picture_data(const FieldFigure& figure, const DrawnField& drawn) const {
    mustache::data picture;
    picture.set("width", std::to_string(drawn.width));
    picture.set("height", std::to_string(drawn.height));
    picture.set("description", description(figure));
    picture.set("address", data_address(figure, drawn));
    picture.set("file", "figures/" + picture_file(figure));
    picture.set("is_animation", figure.is_animation);
    return picture;
  }

  mustache::data figure_data(const Figure& figure, const std::string& page) {
    mustache::data data = caption_data(figure, ++numbers_[page].figure);
    data.set("svg", svg_element(figure, *drawn_figure_++, SvgPlace::in_page));
    return data;
  }

  mustache::data field_data(const FieldFigure& figure, const std::string& page) {
    mustache::data data = caption_data(figure, ++numbers_[page].figure);
    data.set("picture", picture_data(figure, *drawn_field_++));
    return data;
  }

  PageLinks links_;
  std::vector<DrawnFigure>::const_iterator drawn_figure_;
  std::vector<DrawnField>::const_iterator drawn_field_;
  std::map<std::string, Numbers> numbers_;  // of each page
};

}  // namespace

std::size_t rows_on_page(const Table& table) {
  return table.row_ids.empty() ? std::min(table.rows.size(), most_rows) : table.rows.size();
}

std::string table_file(const Table& table) { return "tables/" + table.id + ".csv"; }

std::string csv_of(const Table& table) {
  std::string text = csv_line(table.header);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

std::vector<mustache::data> sections_data(const Report& report, const Drawings& drawings) {
  SectionWriter write(report, drawings);
  std::vector<mustache::data> sections;
  for (const Section& section : report.sections) sections.push_back(write(section));
  return sections;
}

}  // namespace slosh::reports
