#include "reports/pages/glance_markup.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/drawing/gnuplot_curves.hpp"
#include "reports/pages/page_links.hpp"
#include "reports/pages/text_markup.hpp"

namespace slosh::reports {
namespace {

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

}  // namespace

// Screen readers read the word but not the sign.
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

mustache::data entry_data(const Page& page, const DrawnFigure* glance) {
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

}  // namespace slosh::reports
