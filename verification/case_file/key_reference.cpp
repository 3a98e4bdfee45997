#include <fmt/format.h>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

std::string section(const KeyTable& table) {
  const char* quote = table.heading.starts_with('[') ? "`" : "";
  std::string text = fmt::format("### {0}{1}{0}\n\nRequired: {2}.{3}{4}\n\n", quote, table.heading,
                                 table.needed, table.meaning.empty() ? "" : " ", table.meaning);
  text += "| key | value | required | meaning |\n|---|---|---|---|\n";
  for (const KeyEntry& key : table.keys)
    text += fmt::format("| `{}` | {} | {} | {} |\n", key.name, key.value.words(), key.needed.words,
                        key.meaning);
  return text + "\n";
}

std::string measured_on(const MetricEntry& metric) {
  switch (metric.measured_on) {
    case MeasuredOn::any_mode:
      return "the forced or a natural mode";
    case MeasuredOn::natural_mode:
      return "a natural mode";
    case MeasuredOn::whole_window:
      return "the whole window";
    case MeasuredOn::oscillation:
      return "the whole window of an oscillating quantity";
    case MeasuredOn::front:
      return "the whole window of a quantity without modes";
    case MeasuredOn::own_series:
      return "the candidate alone, over the whole run";
    case MeasuredOn::own_mode:
      return "a natural mode of the candidate alone";
    case MeasuredOn::impact:
      return "a published impact";
    case MeasuredOn::repeated_impact:
      return "a published impact, over an ensemble";
    case MeasuredOn::plateau:
      return "the published plateau";
    case MeasuredOn::band:
      return "the window of a record with a band";
    case MeasuredOn::field:
      return "the fields at the snapshot times";
    case MeasuredOn::cost:
      return "the candidate's method against the reference";
  }
  return "";
}

std::string widest(const MetricEntry& metric) {
  switch (metric.widest.scale) {
    case BoundScale::unit:
      return fmt::format("{:g}", metric.widest.below);
    case BoundScale::window:
      return fmt::format("{:g} of the window", metric.widest.below);
    case BoundScale::impact_period:
      return fmt::format("{:g} of the impacts' period", metric.widest.below);
    case BoundScale::tank:
      return "by the tank";
  }
  return "";
}

std::string metric_section() {
  std::string text =
      "## Metrics\n\nA limit lies below the widest bound: a wider one would let every candidate "
      "pass. No range holds\nwhat a candidate of nothing has, or of a lag a wave turned "
      "over.\n[Concepts](concepts.md) explains the metrics.\n\n"
      "| metric | unit | measured on | widest bound | because |\n|---|---|---|---|---|\n";
  for (const MetricEntry& metric : metric_table())
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", metric.name,
                        *metric.unit ? metric.unit : "the quantity's", measured_on(metric),
                        widest(metric), metric.widest.because);
  return text + "\n";
}

std::string quantity_section() {
  std::string text =
      "## Compared quantities\n\nGAUGE stands for the name of a gauge, PROBE for that of a "
      "probe and WALL for left, right, bottom or roof. A pressure gauge with a "
      "cutoff has `wall_pressure@GAUGE/filtered` too.\n\n"
      "| quantity | unit | modes |\n|---|---|---|\n";
  for (const std::string& name : quantity_names())
    text += fmt::format("| `{}` | {} | {} |\n", name, unit_of(name),
                        has_modes(name) ? "forced and natural" : "none");
  return text;
}

}  // namespace

std::string key_reference() {
  std::string text = R"(# Case-file reference

This page lists every key of case and campaign files. `./slosh explain --keys` prints it from the tables that name the
parser's keys.

The files are TOML. The parser refuses an unknown or missing key, a wrong type and an impossible value with
`file:line: key = value: expected ...`, and names up to 20 mistakes at once. A name is made of letters, digits, `_` and
`-`, without a `-` in front. A number has its unit in its key or at `unit` beside it; a limit has that of its metric.

## Case files

)";
  for (const KeyTable& table : case_key_tables()) text += section(table);
  text += "## Campaign files\n\n";
  for (const KeyTable& table : campaign_key_tables()) text += section(table);
  return text + metric_section() + quantity_section();
}

}  // namespace slosh
