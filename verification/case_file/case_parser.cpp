#include "verification/case_file/case_parser.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/changed_input.hpp"
#include "verification/case_file/definition_file.hpp"
#include "verification/case_file/toml_reader.hpp"

namespace slosh {
namespace {

constexpr int schema_version = 1;

TankDefinition read_tank(const TomlTable& tank) {
  tank.allow_only({"length_m", "height_m"});
  return {.length = tank.get("length_m", positive("m")),
          .height = tank.get("height_m", positive("m"))};
}

LiquidDefinition read_liquid(const TomlTable& liquid, const TankDefinition& tank) {
  liquid.allow_only(
      {"fill_depth_m", "density_kg_m3", "kinematic_viscosity_m2_s", "column_width_m"});
  const Rule<double> inside_tank{
      fmt::format("a number > 0 and below the tank's height ({}), in m", tank.height),
      [height = tank.height](double depth) { return depth > 0 && depth < height; }};
  const Rule<double> within_length{
      fmt::format("a number > 0 and below the tank's length ({}), in m", tank.length),
      [length = tank.length](double width) { return width > 0 && width < length; }};
  return {.fill_depth = liquid.get("fill_depth_m", inside_tank),
          .density = liquid.get("density_kg_m3", positive("kg/m3")),
          .kinematic_viscosity = liquid.get("kinematic_viscosity_m2_s", not_negative("m2/s")),
          .column_width = liquid.find("column_width_m", within_length)};
}

GasDefinition read_gas(const TomlTable& gas, const LiquidDefinition& liquid) {
  gas.allow_only({"density_kg_m3", "kinematic_viscosity_m2_s"});
  const Rule<double> lighter{
      fmt::format("a number > 0 and below the liquid's density ({}), in kg/m3", liquid.density),
      [most = liquid.density](double density) { return density > 0 && density < most; }};
  return {.density = gas.get("density_kg_m3", lighter),
          .kinematic_viscosity = gas.get("kinematic_viscosity_m2_s", not_negative("m2/s"))};
}

// Of numbers written with a few decimals, whose quotient rounding spoils in the last digits.
bool is_multiple(double value, double interval) {
  const double quotient = value / interval;
  return std::abs(quotient - std::round(quotient)) <= 1e-9 * quotient;
}

void read_time(const TomlTable& time, CaseDefinition& definition) {
  time.allow_only({"start", "duration_s", "sample_interval_s", "snapshot_times_s"});
  definition.start = time.choice("start", "the frame in which the liquid is first at rest",
                                 {"earth", "tank"}) == "earth"
                         ? Start::earth
                         : Start::tank;
  definition.duration = time.get("duration_s", positive("s"));
  definition.sample_interval = time.get<double>(
      "sample_interval_s",
      {fmt::format("a number > 0 and <= the duration ({}), in s", definition.duration),
       [most = definition.duration](double value) { return value > 0 && value <= most; }});
  definition.snapshot_times = time.increasing_numbers(
      "snapshot_times_s",
      {fmt::format("a number > 0 and <= the duration ({}), a multiple of sample_interval_s ({}), "
                   "in s",
                   definition.duration, definition.sample_interval),
       [&](double value) {
         return value > 0 && value <= definition.duration &&
                is_multiple(value, definition.sample_interval);
       }});
}

bool follows_a_table(const MotionDefinition& motion) {
  return (motion.surge && std::holds_alternative<TableMotion>(*motion.surge)) ||
         (motion.roll && std::holds_alternative<TableMotion>(motion.roll->angle));
}

Rule<int> natural_modes_to_fit(const CaseDefinition& definition) {
  if (definition.gravity == 0)
    return {"0 without gravity: no liquid sways by itself", [](int modes) { return modes == 0; }};
  if (definition.liquid.column_width)
    return {"0 of a dam about to break, which linear theory does not know",
            [](int modes) { return modes == 0; }};
  if (definition.motion.still() && definition.initial_wave)
    return {"0 or 1: a tank that stands has the mode of its initial wave alone",
            [](int modes) { return modes == 0 || modes == 1; }};
  return at_least(0);
}

void read_comparison(const TomlTable& comparison, CaseDefinition& definition) {
  comparison.allow_only(
      {"window_begin_s", "window_end_s", "natural_modes", "forcing_angular_frequency_rad_s"});
  definition.window_begin = comparison.get("window_begin_s", not_negative("s"));
  definition.window_end = comparison.get<double>(
      "window_end_s",
      {fmt::format("a number above window_begin_s ({}) and <= the duration ({}), in s",
                   definition.window_begin, definition.duration),
       [&](double end) { return end > definition.window_begin && end <= definition.duration; }});
  definition.natural_modes = comparison.get("natural_modes", natural_modes_to_fit(definition));
  definition.declared_forcing_frequency =
      comparison.find("forcing_angular_frequency_rad_s", positive("rad/s"));
  if (definition.declared_forcing_frequency && !follows_a_table(definition.motion))
    comparison.refuse("forcing_angular_frequency_rad_s",
                      "no such key where no motion is a table: a sine has its own");
}

template <class Definition>
void add_named(const TomlTable& table, const char* key, Definition definition,
               std::vector<Definition>& definitions) {
  for (const Definition& other : definitions)
    if (other.name == definition.name)
      table.refuse("name", fmt::format("a name that no other {} has", key));
  definitions.push_back(std::move(definition));
}

// Each [[key]] by `read`, no name twice.
template <class Definition, class Read>
std::vector<Definition> read_named(const TomlTable& root, const char* key, Read read) {
  std::vector<Definition> definitions;
  for (const TomlTable& table : root.tables(key)) add_named(table, key, read(table), definitions);
  return definitions;
}

void read_head(const TomlTable& root, CaseDefinition& definition) {
  root.get("schema_version", exactly(schema_version));
  root.allow_only({"schema_version", "name",       "title",  "source",     "tags",
                   "gravity_m_s2",   "tank",       "liquid", "gas",        "obstacle",
                   "initial_wave",   "motion",     "time",   "gauge",      "pressure_gauge",
                   "impacts",        "comparison", "run",    "refinement", "gate",
                   "animation",      "input"});
  definition.name = root.get("name", file_safe_name());
  definition.title = root.get("title", any_text());
  definition.source = root.get("source", any_text());
  for (const PlacedText& tag : root.texts("tags", any_text())) definition.tags.push_back(tag.text);
  definition.gravity = root.get("gravity_m_s2", not_negative("m/s2"));
}

// At least one of either kind.
void read_gauges(const TomlTable& root, CaseDefinition& definition) {
  definition.gauges = read_named<GaugeDefinition>(
      root, "gauge", [&](const TomlTable& gauge) { return read_gauge(gauge, definition); });
  definition.pressure_gauges = read_named<PressureGaugeDefinition>(
      root, "pressure_gauge",
      [&](const TomlTable& gauge) { return read_pressure_gauge(gauge, definition); });
  if (definition.gauges.empty() && definition.pressure_gauges.empty())
    root.refuse("gauge", "at least one [[gauge]] or [[pressure_gauge]]");
}

// Last, so that neither a gate row nor a refinement can name them.
void add_runs_at_ends(const TomlTable& root, CaseDefinition& definition) {
  for (const InputUncertainty& input : definition.inputs) {
    if (input.coarse_run.empty()) continue;
    for (const RunDefinition& run : runs_at_ends(input, run_named(definition, input.coarse_run)))
      add_named(root, "run", run, definition.runs);
  }
}

}  // namespace

CaseDefinition read_case(const std::filesystem::path& file,
                         const std::filesystem::path& experiments) {
  CaseDefinition definition{};
  definition.file = file;
  definition.text = read_definition_text("case", file);
  const TomlTable root(definition.text, file);
  read_head(root, definition);
  definition.tank = read_tank(root.table("tank"));
  definition.liquid = read_liquid(root.table("liquid"), definition.tank);
  definition.gas = read_gas(root.table("gas"), definition.liquid);
  read_time(root.table("time"), definition);
  if (root.has("animation"))
    definition.animation_times = read_animation(root.table("animation"), definition);
  definition.motion = read_motion(root.table("motion"), definition);
  if (definition.gravity == 0 && definition.motion.still())
    root.refuse("gravity_m_s2", "a number > 0, in m/s2, of a tank that stands: nothing would move");
  read_gauges(root, definition);
  if (root.has("impacts"))
    definition.impacts = read_impacts(root.table("impacts"), definition, experiments);
  definition.obstacles = read_named<ObstacleDefinition>(
      root, "obstacle",
      [&](const TomlTable& obstacle) { return read_obstacle(obstacle, definition); });
  refuse_overlaps(root.tables("obstacle"), definition.obstacles);
  if (root.has("initial_wave"))
    definition.initial_wave = read_initial_wave(root.table("initial_wave"), definition);
  read_comparison(root.table("comparison"), definition);
  for (const TomlTable& table : root.tables("run"))
    for (const RunDefinition& run : read_runs(table, definition, experiments))
      add_named(table, "run", run, definition.runs);
  if (definition.runs.empty()) root.refuse("run", "at least one [[run]]");
  definition.refinements = read_named<RefinementDefinition>(
      root, "refinement",
      [&](const TomlTable& refinement) { return read_refinement(refinement, definition); });
  for (const TomlTable& input : root.tables("input"))
    definition.inputs.push_back(read_input(input, definition));
  for (const TomlTable& row : root.tables("gate")) {
    definition.gate.push_back(read_gate_row(row, definition));
  }
  add_runs_at_ends(root, definition);
  return definition;
}

std::filesystem::path find_case(const std::string& name_or_path,
                                const std::filesystem::path& directory) {
  return find_definition_file("case", name_or_path, directory, "");
}

}  // namespace slosh
