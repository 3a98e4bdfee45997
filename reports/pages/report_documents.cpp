#include "reports/pages/report_documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/pages/text_markup.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::object;

constexpr std::size_t most_rows = 100;

template <class Items, class Make>
data list_of(const Items& items, const Make& make) {
  data list(data::type::list);
  for (const auto& item : items) list << make(item);
  return list;
}

// "index.html" for the first page, whose id is empty, and "<id>.html" for the others.
std::string page_file(const std::string& page_id) {
  return (page_id.empty() ? "index" : page_id) + ".html";
}

// Tells which columns hold numbers only; a table without rows has none.
std::vector<bool> numeric_columns(const Table& table) {
  std::vector<bool> numeric;
  for (std::size_t column = 0; column < table.header.size(); ++column)
    numeric.push_back(!table.rows.empty() && std::ranges::all_of(table.rows, [&](const auto& row) {
      return is_numeric(row[column]);
    }));
  return numeric;
}

// The verdict's word is separate from the text after it. `address` is empty for no link.
object cell_data(const std::string& cell, bool numeric, const std::string& address) {
  static constexpr const char* classes[]{"text", "good", "bad", "unsure", "neutral"};
  const CellVerdict verdict = cell_verdict(cell);
  const bool has_sign = verdict != CellVerdict::none;
  const std::size_t word = has_sign ? cell.find(": ") : std::string::npos;
  const bool has_rest = word != std::string::npos;
  return {{"class", !has_sign && numeric ? "number" : classes[static_cast<std::size_t>(verdict)]},
          {"sign", verdict_sign(verdict)},
          {"has_sign", has_sign},
          {"text", html_text(cell.substr(0, word))},
          {"has_rest", has_rest},
          {"rest", has_rest ? html_text(cell.substr(word + 2)) : ""},
          {"is_link", !address.empty()},
          {"address", address}};
}

// A verdict as a class, a sign, a word and a sentence. Screen readers read the word but not the
// sign.
object outcome_data(Outcome outcome, const std::string& sentence) {
  const auto [mark, word] = outcome_sign(outcome);
  return {{"class", outcome == Outcome::pass           ? "good"
                    : outcome == Outcome::watched      ? "watched"
                    : outcome == Outcome::inconclusive ? "unsure"
                                                       : "bad"},
          {"sign", mark},
          {"word", word},
          {"sentence", html_text(sentence)}};
}

// The entry of a page, in the list of pages and in the links of its neighbours. `glance` may be
// null.
object entry_data(const Page& page, const DrawnFigure* glance = nullptr) {
  object entry{{"title", page.title}, {"address", page_file(page.id)}};
  if (!page.verdict.empty()) entry["outcome"] = outcome_data(page.outcome, page.verdict);
  if (glance && !page.remark.empty()) entry["remark"] = html_text(page.remark);
  if (glance && page.glance)
    entry["glance"] = object{{"svg", svg_element(*page.glance, *glance, SvgPlace::in_page)},
                             {"shows", html_text(page.glance->caption)}};
  return entry;
}

// One entry for each label of all glances. gnuplot's dash "(14,3)" is SVG's "14,3".
data legend_data(const Report& report) {
  data entries(data::type::list);
  std::vector<std::string> known;
  for (const Page& page : report.pages) {
    if (!page.glance) continue;
    for (const Curve& curve : page.glance->curves) {
      if (std::ranges::find(known, curve.label) != known.end()) continue;
      known.push_back(curve.label);
      const Stroke stroke = stroke_of(curve.look.value_or(Look{}));
      const std::string dash = stroke.dash;
      entries << object{{"label", html_text(curve.label)},
                        {"colour", stroke.colour},
                        {"dash", dash == "solid" ? "none" : dash.substr(1, dash.size() - 2)}};
    }
  }
  return entries;
}

// The list of a report's pages with their verdicts, and for each the small figure of its main
// result: the report at a glance.
object glances_data(const Report& report, const Drawings& drawings) {
  data entries(data::type::list);
  for (std::size_t i = 0; i < report.pages.size(); ++i)
    if (report.pages[i].continues.empty())
      entries << entry_data(report.pages[i], &drawings.glances[i]);
  return {{"entries", entries},
          {"legend", legend_data(report)},
          {"has_legend", std::ranges::any_of(report.pages, [](const Page& page) {
             return page.glance.has_value();
           })}};
}

class PageWriter {
 public:
  PageWriter(const Report& report, const Drawings& drawings)
      : report_(report),
        page_of_anchor_(anchors_of(report)),
        drawn_figure_(drawings.figures.begin()),
        drawn_field_(drawings.fields.begin()) {
    for (const Section& section : report.sections) sections_.push_back(section_data(section));
  }

  object page_data(const Page& page) const {
    const bool is_first = page.id.empty();
    data sections(data::type::list);
    for (std::size_t i = 0; i < report_.sections.size(); ++i)
      if (report_.sections[i].page == page.id) sections << sections_[i];
    object written{{"title", page.title},
                   {"doubts", list_of(is_first ? report_.doubts : page.doubts,
                                      [](const std::string& doubt) {
                                        return object{{"doubt", html_text(doubt)}};
                                      })},
                   {"sections", sections}};
    if (is_first && !report_.coverage.empty()) written["coverage"] = html_text(report_.coverage);
    if (!page.verdict.empty()) written["outcome"] = banner_data(page);
    if (is_first) return written;
    std::vector<Page> appendices = report_.pages;
    std::erase_if(appendices, [&](const Page& one) { return one.continues != page.id; });
    written["appendices"] = list_of(appendices, [](const Page& one) { return entry_data(one); });
    return written;
  }

 private:
  // "#row-surge-3" on the same page, "surge.html#row-surge-3" from another one.
  std::string to_anchor(const std::string& anchor, const std::string& from_page) const {
    const std::string& page = page_of_anchor_.at(anchor);
    return (page == from_page ? "" : page_file(page)) + "#" + anchor;
  }

  // The verdict at the top of a page. The first page's verdict names what decides it.
  object banner_data(const Page& page) const {
    object banner = outcome_data(page.outcome, page.verdict);
    const auto& [lead, decides, finding] = report_.decision;
    if (!page.id.empty() || decides.text.empty()) return banner;
    object decision{{"lead", html_text(lead)},
                    {"text", html_text(decides.text)},
                    {"address", to_anchor(decides.anchor, page.id)}};
    if (!finding.empty()) decision["finding"] = html_text(finding);
    banner["decision"] = decision;
    return banner;
  }

  // Must be called once for each section, in the report's order.
  object section_data(const Section& section) {
    const std::string& page = section.page;
    data figures(data::type::list);
    for (const Figure& figure : section.figures) {
      object drawn = caption_data(figure, ++last_figure_[page]);
      drawn["svg"] = svg_element(figure, *drawn_figure_++, SvgPlace::in_page);
      figures << drawn;
    }
    for (const FieldFigure& figure : section.fields) {
      object drawn = caption_data(figure, ++last_figure_[page]);
      drawn["picture"] = picture_data(figure, *drawn_field_++);
      figures << drawn;
    }
    const std::size_t pictures = section.figures.size() + section.fields.size();
    return {{"id", section.id},
            {"title", section.title},
            {"paragraphs", list_of(section.paragraphs,
                                   [](const std::string& text) {
                                     return object{{"text", html_text(text)}};
                                   })},
            {"tables",
             list_of(section.tables, [&](const Table& table) { return table_data(table, page); })},
            {"figures", figures},
            {"has_figures", pictures > 0},
            {"has_parts", section.tables.size() + pictures > 1}};
  }

  object row_data(const Table& table, std::size_t row, const std::vector<bool>& numeric,
                  const std::string& page) const {
    const std::vector<std::string>& cells = table.rows[row];
    const std::string reason = table.reasons.empty() ? "" : table.reasons[row];
    const auto cell = [&](std::size_t i) {
      const std::string anchor = table.links.empty() ? "" : table.links[row][i];
      return cell_data(cells[i], numeric[i], anchor.empty() ? "" : to_anchor(anchor, page));
    };
    data others(data::type::list);
    for (std::size_t i = 1; i < cells.size(); ++i) {
      object other = cell(i);
      other["has_reason"] = i + 1 == cells.size() && !reason.empty();
      other["reason"] = html_text(reason);
      others << other;
    }
    object line{{"has_id", !table.row_ids.empty()},
                {"row_id", table.row_ids.empty() ? "" : table.row_ids[row]},
                {"cells", others}};
    if (!cells.empty()) line["first"] = cell(0);
    return line;
  }

  object table_data(const Table& table, const std::string& page) {
    const std::vector<bool> numeric = numeric_columns(table);
    data header(data::type::list), rows(data::type::list);
    for (std::size_t i = 0; i < table.header.size(); ++i)
      header << object{{"text", html_text(table.header[i])},
                       {"class", numeric[i] ? "number" : "text"}};
    const std::size_t shown = rows_on_page(table);
    for (std::size_t row = 0; row < shown; ++row) rows << row_data(table, row, numeric, page);
    object written = caption_data(table, ++last_table_[page]);
    written["cut"] = false;
    if (shown < table.rows.size())
      written["cut"] = object{{"shown", std::to_string(shown)},
                              {"all", std::to_string(table.rows.size())},
                              {"address", table_file(table)}};
    written["header"] = std::move(header);
    written["rows"] = std::move(rows);
    written["is_folded"] = table.is_folded;
    written["rows_count"] = std::to_string(table.rows.size());
    return written;
  }

  template <class Captioned>
  static object caption_data(const Captioned& part, int number) {
    return {{"id", part.id},
            {"number", std::to_string(number)},
            {"title", html_text(part.title)},
            {"caption", html_text(part.caption)}};
  }

  // On a page a picture links to the file that holds all its detail.
  static object picture_data(const FieldFigure& figure, const DrawnField& drawn) {
    return {{"width", std::to_string(drawn.width)},      {"height", std::to_string(drawn.height)},
            {"description", description(figure)},        {"address", data_address(figure, drawn)},
            {"file", "figures/" + picture_file(figure)}, {"is_animation", figure.is_animation}};
  }

  const Report& report_;
  std::map<std::string, std::string> page_of_anchor_;
  std::vector<DrawnFigure>::const_iterator drawn_figure_;
  std::vector<DrawnField>::const_iterator drawn_field_;
  std::map<std::string, int> last_table_, last_figure_;  // of each page
  std::vector<object> sections_;
};

std::string figure_page_style() {
  return fmt::format(
      "body{{font-family:system-ui,sans-serif;max-width:800px;margin:2rem auto;padding:0 1rem;"
      "background:{};color:{}}}svg{{max-width:100%;height:auto}}figure{{margin:0 0 2rem}}"
      "@media (prefers-color-scheme: dark){{body{{background:{};color:{}}}\n{}}}",
      paper.light, ink.light, paper.dark, ink.dark, dark_rules());
}

}  // namespace

std::map<std::string, std::string> anchors_of(const Report& report) {
  std::map<std::string, std::string> pages;
  for (const Section& section : report.sections) {
    pages["section-" + section.id] = section.page;
    for (const Figure& figure : section.figures) pages["figure-" + figure.id] = section.page;
    for (const FieldFigure& figure : section.fields) pages["figure-" + figure.id] = section.page;
    for (const Table& table : section.tables) {
      pages["table-" + table.id] = section.page;
      for (const std::string& row : table.row_ids) pages["row-" + row] = section.page;
    }
  }
  return pages;
}

std::size_t rows_on_page(const Table& table) {
  return table.row_ids.empty() ? std::min(table.rows.size(), most_rows) : table.rows.size();
}

std::string table_file(const Table& table) { return "tables/" + table.id + ".csv"; }

std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings) {
  const PageWriter writer(report, drawings);
  std::vector<Page> pages{{"", report.title, report.verdict, report.outcome}};
  pages.insert(pages.end(), report.pages.begin(), report.pages.end());
  std::vector<HtmlFile> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    object document{{"report_title", report.title},
                    {"subtitle", report.subtitle},
                    {"style", page_style},
                    {"dark_rules", dark_rules()},
                    {"sections_part", kainjow::mustache::partial([] { return sections_template; })},
                    {"glances_part", kainjow::mustache::partial([] { return glances_template; })},
                    {"banner_part", kainjow::mustache::partial([] { return banner_template; })},
                    {"cell_part", kainjow::mustache::partial([] { return cell_template; })},
                    {"page", writer.page_data(pages[i])},
                    {"is_first", i == 0},
                    {"has_pages", i == 0 && pages.size() > 1},
                    {"has_neighbours", pages.size() > 1}};
    if (i == 0) document["glances"] = glances_data(report, drawings);
    if (i > 0) document["previous"] = entry_data(pages[i - 1]);
    if (i + 1 < pages.size()) document["next"] = entry_data(pages[i + 1]);
    kainjow::mustache::mustache page(page_template);
    files.push_back({page_file(pages[i].id), page.render(data(document))});
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
