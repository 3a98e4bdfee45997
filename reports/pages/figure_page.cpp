#include "reports/pages/figure_page.hpp"

#include <fmt/format.h>

#include "reports/drawing/draw_figure.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/pages/text_markup.hpp"

namespace slosh::reports {
namespace {

std::string style() {
  return fmt::format(
      "body{{font-family:system-ui,sans-serif;max-width:800px;margin:2rem auto;padding:0 1rem;"
      "background:{};color:{}}}svg{{max-width:100%;height:auto}}figure{{margin:0 0 2rem}}"
      "@media (prefers-color-scheme: dark){{body{{background:{};color:{}}}\n{}}}",
      paper.light, ink.light, paper.dark, ink.dark, dark_rules());
}

}  // namespace

std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n<h1>{0}</h1>\n",
      html_text(title), style());
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
