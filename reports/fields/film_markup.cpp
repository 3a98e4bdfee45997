#include "reports/fields/film_markup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <kainjow/mustache.hpp>
#include <vector>

#include "reports/drawing/figure_palette.hpp"
#include "reports/fields/draw_field.hpp"
#include "reports/model/file_formats.hpp"
#include "reports/templates.hpp"

namespace slosh::reports {
namespace {

namespace mustache = kainjow::mustache;

// The colour bar's text does not shrink with the panels.
constexpr double bar_canvas = 340, bar_length = 270;  // [px]: a phone's width, and room for labels
constexpr double seam = 0.5;               // [px], by which a colour reaches under the next
constexpr double longest_scale_bar = 0.4;  // of a cell
constexpr double wide_cell = 1.5;          // width over height: two of these are stacked on a phone

std::string number(double value) { return fmt::format("{:.4g}", value); }

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Where a part of several is, in percent of the way from the first to the last: a background's
// position counts so.
double share(std::size_t index, std::size_t count) {
  return count > 1 ? 100.0 * static_cast<double>(index) / static_cast<double>(count - 1) : 0;
}

mustache::data bar_ticks_data(const ColourRange& range) {
  const BarTicks between = bar_ticks(range, bar_length);
  mustache::data ticks(mustache::data::type::list);
  const auto add = [&](double value, const std::string& label) {
    const double fraction = (value - range.lower) / (range.upper - range.lower);
    mustache::data tick{"label", label};
    tick.set("x", number((bar_canvas - bar_length) / 2 + fraction * bar_length));
    ticks << tick;
  };
  add(range.lower, range.lower_label);
  for (double value = between.first; value <= between.last + range.step / 4; value += range.step)
    add(value, bar_label(std::abs(value) < range.step / 4 ? 0 : value));
  add(range.upper, range.upper_label);
  return ticks;
}

void set_key(const FieldFigure& figure, const FilmStrip& strip, mustache::data& data) {
  const std::vector<std::string> colours = film_colours();
  const double step = bar_length / static_cast<double>(colours.size());
  mustache::data steps(mustache::data::type::list);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    mustache::data one{"colour", colours[i]};
    one.set("x", number((bar_canvas - bar_length) / 2 + step * static_cast<double>(i)));
    steps << one;
  }
  data.set("steps", steps);
  data.set("step", number(step + seam));
  data.set("ticks", bar_ticks_data(strip.range));
  data.set("bar_canvas", number(bar_canvas));
  data.set("bar_middle", number(bar_canvas / 2));
  data.set("quantity", figure.value_label);
  data.set("ink", ink.light);
  const double cell = strip.layout.cell_width,
               length = scale_bar_length(strip.layout, longest_scale_bar * cell);
  data.set("scale_share", number(100 * length * strip.layout.scale / cell));
  data.set("scale_text", scale_bar_text(length));
  const FieldArrows& arrows = strip.arrows;
  if (arrow_text(arrows).empty()) return;
  mustache::data arrow{"text", arrow_text(arrows)};
  arrow.set("share", number(100 * arrows.legend_speed * arrows.pixels_per_speed / cell));
  data.set("arrow", arrow);
}

// The moments of the strip at which the run recorded nothing.
std::vector<std::size_t> missing_moments(const FieldFigure& figure, const FilmStrip& strip,
                                         std::size_t column) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < strip.moments.size(); ++i)
    if (figure.panels[strip.moments[i] * at(figure.columns) + column].x.empty())
      missing.push_back(i);
  return missing;
}

mustache::data panel_data(const FieldFigure& figure, const FilmStrip& strip, std::size_t column) {
  const std::vector<std::size_t> missing = missing_moments(figure, strip, column);
  const std::string& name = figure.film->names[column];
  mustache::data panel{"name", name};
  panel.set("missing", fmt::format("{}", fmt::join(missing, " ")));
  panel.set("is_recorded",
            std::find(missing.begin(), missing.end(), strip.poster) == missing.end());
  panel.set("description",
            fmt::format("{}. Colour: {} from {} to {}.{}", name, figure.value_label,
                        strip.range.lower_label, strip.range.upper_label,
                        arrow_text(strip.arrows).empty() ? "" : " Arrows: velocity."));
  panel.set("width", std::to_string(strip.layout.cell_width));
  panel.set("height", std::to_string(strip.layout.cell_height));
  panel.set("strip_width", std::to_string(100 * strip.layout.columns));
  panel.set("column", number(share(column, at(strip.layout.columns))));
  return panel;
}

int columns_on_a_phone(const FieldLayout& layout) {
  const bool is_wide = layout.cell_width > wide_cell * layout.cell_height;
  return layout.columns == 1 || (layout.columns == 2 && is_wide) ? 1 : 2;
}

std::vector<std::string> labels_of(const Film& film, const FilmStrip& strip) {
  std::vector<std::string> labels;
  for (const std::size_t row : strip.moments) labels.push_back(film.labels[row]);
  return labels;
}

}  // namespace

std::string film_element(const FieldFigure& figure, const DrawnFilm& drawn) {
  const Film& film = *figure.film;
  const FilmStrip& strip = drawn.strip;
  mustache::data panels(mustache::data::type::list);
  for (std::size_t column = 0; column < at(strip.layout.columns); ++column)
    panels << panel_data(figure, strip, column);
  mustache::data data;
  set_key(figure, strip, data);
  data.set("labels", fmt::format("{}", fmt::join(labels_of(film, strip), "|")));
  data.set("cursor", fmt::format("{:.2f}", fmt::join(drawn.cursors, " ")));
  data.set("address", data_address(strip.png));
  data.set("poster", std::to_string(strip.poster));
  data.set("poster_row", number(share(strip.poster, strip.moments.size())));
  data.set("poster_label", film.labels[film.poster]);
  data.set("last", std::to_string(strip.moments.size() - 1));
  data.set("across", std::to_string(std::min(strip.layout.columns, film_columns)));
  data.set("across_phone", std::to_string(columns_on_a_phone(strip.layout)));
  data.set("cell_width", std::to_string(strip.shown_width));
  data.set("panels", panels);
  data.set("history", svg_element(film.history, drawn.history, SvgPlace::in_page));
  mustache::mustache element(film_template);
  return element.render(data);
}

std::string film_caption(const FieldFigure& figure, const DrawnFilm& drawn) {
  const std::size_t all = figure.film->times.size(), shown = drawn.strip.moments.size();
  if (shown == all) return figure.caption;
  return fmt::format("{} To keep the page light, it plays {} of these {} moments.", figure.caption,
                     shown, all);
}

std::string film_script_element() { return fmt::format("<script>{}</script>", film_script); }

std::string film_script_policy() {
  const std::string hexadecimal = film_script_sha256;
  std::string bytes;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16));
  return fmt::format("script-src 'sha256-{}'", base64(bytes));
}

}  // namespace slosh::reports
