#include "reports/tests/sample_report.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace slosh::reports {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Two beating sines, as a surging tank's elevation [mm].
double elevation(double time, double amplitude, double delay) {
  return amplitude *
         (5.6 * std::sin(1.4835 * (time - delay)) - 3.4 * std::sin(4.9665 * (time - delay)));
}

Curve elevation_curve(const std::string& label, double amplitude, double delay, std::size_t samples,
                      Curve::Style style) {
  Curve curve{.label = label, .x = {}, .y = {}, .y_error = {}, .style = style};
  for (std::size_t i = 0; i < samples; ++i) {
    curve.x.push_back(20.0 * static_cast<double>(i) / static_cast<double>(samples - 1));
    curve.y.push_back(elevation(curve.x.back(), amplitude, delay));
  }
  return curve;
}

Figure time_history() {
  Figure figure{
      .id = "time-history",
      .title = "Surface elevation 0.05 m from the right wall",
      .caption =
          "As figure 1 of the paper. The gap in the SPH curve is a gauge that lost the surface.",
      .x_label = "time t (s)",
      .y_label = "elevation η (mm)",
      .curves = {elevation_curve("linear theory", 1.0, 0.0, 2001, Curve::Style::line),
                 elevation_curve("SPH <recommended>, dp = 10 mm", 0.93, 0.04, 2001,
                                 Curve::Style::line),
                 elevation_curve("interFoam & friends, dx = 5 mm", 1.01, 0.01, 2001,
                                 Curve::Style::dashed)},
      .bands = {},
      .markers = {}};
  for (std::size_t i = 900; i < 1000; ++i) figure.curves[1].y[i] = nan;
  return figure;
}

Figure residuals() {
  Figure figure{.id = "residuals",
                .title = "Residuals against linear theory",
                .caption = "The bands are the tolerances of the gate.",
                .x_label = "time t (s)",
                .y_label = "residual (mm)",
                .curves = {elevation_curve("SPH", 0.12, 0.3, 1001, Curve::Style::line),
                           elevation_curve("interFoam", 0.04, 0.1, 1001, Curve::Style::line)},
                .bands = {{"tolerance, SPH", -1.0, 1.0}, {"tolerance, VOF", -0.3, 0.3}},
                .markers = {}};
  return figure;
}

Figure spectrum() {
  Figure figure{
      .id = "spectrum",
      .title = "Power spectra, predicted frequencies marked",
      .caption = "",
      .x_label = "angular frequency (rad/s)",
      .y_label = "power (mm²s)",
      .log_y = true,
      .x_range = {0.0, 16.0},
      .curves = {},
      .bands = {},
      .markers = {
          {"ω (forcing)", 1.4835}, {"ω₁", 4.9665}, {"ω₂", 9.5757}, {"2ω₁", 9.933}, {"ω₃", 12.4}}};
  for (const auto& [label, width] :
       {std::pair{"linear theory", 0.02}, std::pair{"SPH", 0.1}, std::pair{"VOF", 0.04}}) {
    Curve curve{.label = label, .x = {}, .y = {}, .y_error = {}};
    for (double w = 0.02; w < 20; w += 0.02) {
      curve.x.push_back(w);
      const auto peak = [&, width = width](double centre, double power) {
        return power / (1 + std::pow((w - centre) / width, 2));
      };
      curve.y.push_back(peak(1.4835, 30) + peak(4.9665, 12) + peak(9.5757, 0.4) + 1e-5);
    }
    figure.curves.push_back(curve);
  }
  return figure;
}

Figure cost() {
  return {
      .id = "cost",
      .title = "Error against run time",
      .caption = "Bars: 95 % confidence. One run did not finish and is not drawn.",
      .x_label = "run time (s)",
      .y_label = "amplitude error (%)",
      .log_x = true,
      .log_y = true,
      .curves =
          {{"li2010", {3.1, 22, 180}, {41, 27, 19.5}, {4, 2.5, 2}, Curve::Style::line_points},
           {"recommended",
            {4.2, 31, 260},
            {12, 4.9, 2.1},
            {1.5, 0.6, 0.5},
            Curve::Style::line_points},
           {"interFoam", {15, 95, nan}, {2.8, 0.9, nan}, {0.2, 0.1, nan}, Curve::Style::points}},
      .bands = {{"tolerance", -std::numeric_limits<double>::infinity(), 5}},
      .markers = {}};
}

Table gate_table() {
  return {
      .id = "gate",
      .title = "Gate rows",
      .caption = "Each limit comes from the case file.",
      .header = {"Candidate", "Quantity", "Error", "Limit", "Reason", "Verdict"},
      .rows = {
          {"interFoam 5 mm", "amplitude, forced mode", "0.82 %", "1.5 %", "peers reach 1 %",
           "pass"},
          {"interFoam 5 mm", "phase, forced mode", "0.41 deg", "1 deg", "peers reach 0.5 deg",
           "pass"},
          {"recommended 10 mm", "amplitude, forced mode", "6.30 %", "5 %", "a < b & c", "FAIL"},
          {"recommended 5 mm", "natural frequency", "-", "1.5 %", "two-layer theory",
           "not selected"},
          {"li2010 10 mm", "damping | decay", "nan", "0.1", "the paper's own", "not compared"}}};
}

Table run_table() {
  return {.id = "runs",
          .title = "Runs and how to repeat them",
          .caption = "",
          .header = {"Run", "Particles", "Time (s)", "Command"},
          .rows = {{"li2010-20mm", "1050", "3.1",
                    "`./slosh run surge_linear --solver li2010 --dp 0.02 | tee log`"},
                   {"li2010-10mm", "3900", "22.0",
                    "`./slosh run surge_linear --solver li2010 --dp 0.01`"}}};
}

// Water in a standing wave of the tank's first mode. Its places are on a lattice, or, for
// particles, off it by up to a fifth of the spacing.
FieldPanel sloshing_panel(const std::string& label, double spacing, double phase, bool particles) {
  const double length = 0.6, height = 0.3, depth = 0.12, wave = std::numbers::pi / length;
  FieldPanel panel{.label = label,
                   .angle = 0.07 * std::sin(phase),
                   .axis_x = length / 2,
                   .axis_z = 0.05,
                   .tank_length = length,
                   .tank_height = height,
                   .point_width = spacing,
                   .point_height = spacing,
                   .x = {},
                   .z = {},
                   .value = {},
                   .arrow_x = {},
                   .arrow_z = {},
                   .arrow_u = {},
                   .arrow_w = {}};
  std::minstd_rand random(1);
  const auto off_lattice = [&] {
    return particles ? spacing * (0.4 * static_cast<double>(random() - random.min()) /
                                      static_cast<double>(random.max()) -
                                  0.2)
                     : 0.0;
  };
  for (double x = spacing / 2; x < length; x += spacing) {
    const double surface = depth + 0.05 * std::cos(phase) * std::cos(wave * x);
    for (double z = spacing / 2; z < surface; z += spacing) {
      panel.x.push_back(x + off_lattice());
      panel.z.push_back(z + off_lattice());
      panel.value.push_back(1000 * 9.81 * (surface - panel.z.back()));
      const double speed = 0.6 * std::sin(phase) / std::sinh(wave * depth);
      panel.arrow_u.push_back(speed * std::sin(wave * x) * std::cosh(wave * z));
      panel.arrow_w.push_back(-speed * std::cos(wave * x) * std::sinh(wave * z));
    }
  }
  panel.arrow_x = panel.x;
  panel.arrow_z = panel.z;
  return panel;
}

}  // namespace

FieldFigure sloshing_field(const std::string& id, int moments, double spacing) {
  FieldFigure figure{.id = id,
                     .title = "Pressure in the rolling tank",
                     .caption = "Each row is one moment.",
                     .value_label = "pressure (Pa)",
                     .columns = 3,
                     .panels = {}};
  for (int moment = 0; moment < moments; ++moment) {
    const double phase = 0.6 + 1.3 * moment;
    const std::string time = ", t = " + std::to_string(moment) + ".25 s";
    figure.panels.push_back(sloshing_panel("SPH <recommended> " + id + time, spacing, phase, true));
    figure.panels.push_back(sloshing_panel("li2010" + time, 2 * spacing, phase - 0.2, true));
    figure.panels.push_back(sloshing_panel("interFoam" + time, 1.5 * spacing, phase, false));
  }
  return figure;
}

FieldFigure sloshing_animation(const std::string& id, int moments, int runs, double spacing) {
  FieldFigure figure{.id = id,
                     .title = "The flow in the rolling tank",
                     .caption = "Animation.",
                     .value_label = "pressure (Pa)",
                     .columns = runs,
                     .panels = {},
                     .is_animation = true};
  for (int moment = 0; moment < moments; ++moment)
    for (int run = 0; run < runs; ++run)
      figure.panels.push_back(sloshing_panel(
          "run " + std::to_string(run) + ", t = " + std::to_string(200 + 25 * moment) + " cs",
          spacing, 0.6 + 0.4 * moment + 0.2 * run, run != 2));
  if (moments > 1 && runs > 1) {
    FieldPanel& missing = figure.panels[static_cast<std::size_t>(runs + 1)];
    missing.x = missing.z = missing.value = {};
  }
  return figure;
}

Report sample_report() {
  Report report;
  report.title = "Small-amplitude surge: SPH & VOF against <linear> theory";
  report.verdict =
      "1 of 5 checks is violated: `recommended` at 10 mm errs by 6.3 % in the forced "
      "mode "
      "(limit 5 %).";
  report.subtitle = "2024-05-17, slosh 0.1.0, 2 cores";
  report.sections = {
      {"verdict",
       "Gate",
       {"Every row compares one run with its reference over 4 s to 20 s."},
       {gate_table()},
       {},
       {}},
      {"waves",
       "Waves at the gauge",
       {"The forced mode stays a small fraction of a particle: 5.6 mm against a spacing of 10 mm.",
        "Text is shown as it is: <script>document.title = 'broken'</script> & \"quotes\"."},
       {},
       {time_history(), residuals(), spectrum()},
       {sloshing_field("pressure-field", 1, 0.02)}},
      {"cost", "Cost", {}, {run_table()}, {cost()}, {}}};
  report.results_json = "{\"schema\": 1, \"passed\": false}\n";
  return report;
}

Report paged_report() {
  Report report = sample_report();
  report.pages = {{"waves", "Waves & wind", "5 of 5 checks hold.", Outcome::pass},
                  {"cost", "What it costs", "", {}}};
  report.sections[1].page = "waves";
  report.sections[2].page = "cost";
  report.sections[2].tables[0].row_ids = {"runs-1", "runs-2"};
  Table& gate = report.sections[0].tables[0];
  gate.links.assign(gate.rows.size(), std::vector<std::string>(gate.header.size()));
  gate.links[0][0] = "section-waves";
  gate.links[2][5] = "row-runs-2";
  return report;
}

Figure heavy_figure(const std::string& id) {
  Figure figure{.id = id,
                .title = id,
                .caption = "",
                .x_label = "time (s)",
                .y_label = "elevation (mm)",
                .curves = {},
                .bands = {},
                .markers = {}};
  for (int i = 0; i < 6; ++i) {
    figure.curves.push_back(elevation_curve("curve " + std::to_string(i), 1.0 - 0.1 * i, 0.05 * i,
                                            2001,
                                            i % 2 ? Curve::Style::dashed : Curve::Style::line));
  }
  return figure;
}

}  // namespace slosh::reports
