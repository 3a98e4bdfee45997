// [[panel]] of a case file: ensembles that are compared with one another, and what is refused.
#include <gtest/gtest.h>

#include "verification/tests/trial_case.hpp"

namespace slosh::panel_section_test {
namespace {

const std::string runs = R"([[run]]
name = "particles"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.01
start_disorder = 0.1
repeats = 4
[[run]]
name = "pair"
solver = "interfoam"
cells_x = 20
cells_z = 20
start_disorder = 0.1
repeats = 2
[[run]]
name = "cells"
solver = "interfoam"
cells_x = 20
cells_z = 20
start_disorder = 0.1
repeats = 3
[[run]]
name = "air"
solver = "compressible_interfoam"
cells_x = 20
cells_z = 20
start_disorder = 0.1
repeats = 3
)";

const std::string panel = R"([[panel]]
name = "solvers"
runs = ["particles", "cells", "air"]
metrics = ["rms", "lag"]
compressibility = ["air", "cells"]
reason = "a reason"
)";

const std::string pressure_and_impacts = R"([[pressure_gauge]]
name = "B"
wall = "left"
position_m = 0.1
filter_cutoff_Hz = 5.0
[impacts]
gauge = "B"
times_s = [2.0, 4.0]
period_s = 2.0
peaks_Pa = [3000.0, 3000.0]
peaks_sd_Pa = [300.0, 300.0]
plateau_begin_s = 2.5
plateau_end_s = 2.8
plateau_Pa = 500.0
arrival_share = 0.1
arrivals_s = [1.9, 3.9]
source = "a source"
)";

std::string text_with(const std::string& from, const std::string& to,
                      const std::string& before = "") {
  std::string text = panel;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return valid_text + before + runs + text.replace(at, from.size(), to);
}

std::string complaint_with(const std::string& from, const std::string& to,
                           const std::string& before = "") {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text_with(from, to, before)));
}

// What the parser says where the [[run]] of this name has `to` in the place of `from`.
std::string complaint_with_run(const std::string& name, const std::string& from,
                               const std::string& to, const std::string& before = "") {
  std::string text = runs;
  const std::size_t at = text.find(from, text.find("name = \"" + name + "\""));
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  const Workspace workspace;
  return complaint(workspace.write(
      "trial.toml", valid_text + before + text.replace(at, from.size(), to) + panel));
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PanelSection, ReadsEnsemblesAndWhatIsComparedOfThem) {
  const CaseDefinition definition = read_text(valid_text + runs + panel);
  ASSERT_EQ(definition.panels.size(), 1U);
  const PanelDefinition& read = definition.panels[0];
  EXPECT_EQ(read.name, "solvers");
  EXPECT_EQ(read.runs, (std::vector<std::string>{"particles", "cells", "air"}));
  EXPECT_EQ(read.quantity, "elevation@right");
  EXPECT_EQ(read.metrics, (std::vector<PanelMetric>{PanelMetric::rms, PanelMetric::lag}));
  ASSERT_TRUE(read.air);
  EXPECT_EQ(read.air->compressible, "air");
  EXPECT_EQ(read.air->incompressible, "cells");
  EXPECT_FALSE(read.impulse_duration);
}

TEST(PanelSection, RefusesRunsThatAreNoEnsembles) {
  EXPECT_TRUE(holds(complaint_with("\"particles\"", "\"nobody\""),
                    "\"nobody\": expected a run of this case"));
  EXPECT_TRUE(holds(complaint_with("\"particles\"", "\"particles_2\""), "no later member"));
  EXPECT_TRUE(holds(complaint_with("\"particles\"", "\"coarse\""),
                    "\"coarse\": expected an ensemble, repeats = 3 or more in its [[run]]; it has "
                    "1"));
  EXPECT_TRUE(holds(complaint_with("\"particles\"", "\"pair\""), "it has 2"));
  EXPECT_TRUE(holds(complaint_with("\"particles\"", "\"cells\""), "each run once"));
  EXPECT_TRUE(holds(complaint_with("\"particles\", \"cells\", \"air\"", "\"air\""), "two runs or"));
}

TEST(PanelSection, RefusesMetricsThatItDoesNotHave) {
  const std::string said = complaint_with("\"rms\"", "\"rms_error\"");
  EXPECT_TRUE(holds(said, "\"rms_error\": expected a metric of a panel: impact_peak, ")) << said;
  EXPECT_TRUE(holds(complaint_with("\"lag\"", "\"rms\""), "each metric once"));
  EXPECT_TRUE(
      holds(complaint_with("\"lag\"", "\"impact_peak\""), "this one needs a case with [impacts]"));
  EXPECT_TRUE(holds(complaint_with("[\"rms\", \"lag\"]", "[]"), "one metric or more"));
  EXPECT_TRUE(holds(complaint_with("metrics", "quantity = \"elevation@middle\"\nmetrics"),
                    "expected a compared quantity of this case"));
}

TEST(PanelSection, AsksForWhatTheMetricsOfImpactsNeed) {
  const auto complaint_of = [](const std::string& quantity, const std::string& metrics,
                               const std::string& more = "") {
    return complaint_with("metrics = [\"rms\", \"lag\"]",
                          "quantity = \"" + quantity + "\"\nmetrics = [" + metrics + "]" + more,
                          pressure_and_impacts);
  };
  const std::string both = "\"impact_peak\", \"impact_arrival\"";
  EXPECT_EQ(complaint_of("wall_pressure@B", both), "");
  EXPECT_EQ(complaint_of("wall_pressure@B/filtered", both), "");
  EXPECT_TRUE(holds(complaint_of("elevation@right", both),
                    "needs the quantity wall_pressure@B or wall_pressure@B/filtered"));
  EXPECT_EQ(complaint_of("wall_pressure@B", "\"plateau\""), "");
  EXPECT_TRUE(holds(complaint_of("wall_pressure@B", "\"impulse\""), "impulse_duration_s"));
  EXPECT_EQ(complaint_of("wall_pressure@B", "\"impulse\"", "\nimpulse_duration_s = 0.05"), "");
  EXPECT_TRUE(holds(complaint_of("wall_pressure@B", "\"rms\"", "\nimpulse_duration_s = 0.05"),
                    "no such key without the metric impulse"));
}

TEST(PanelSection, TakesTheShareOfTheAirFromACompressibleRunAndAnIncompressibleOne) {
  const auto complaint_of = [](const std::string& pair) {
    return complaint_with("[\"air\", \"cells\"]", pair);
  };
  EXPECT_TRUE(holds(complaint_of("[\"cells\", \"air\"]"),
                    "\"cells\": expected one of the panel's runs of compressibleInterFoam"));
  EXPECT_TRUE(holds(complaint_of("[\"air\", \"particles\"]"), "runs of interFoam"));
  EXPECT_TRUE(holds(complaint_of("[\"air\", \"pair\"]"), "runs of interFoam"));
  EXPECT_TRUE(holds(complaint_of("[\"air\"]"), "two of the panel's runs"));
}

TEST(PanelSection, TakesTheShareOfTheAirFromTwoRunsThatDifferInTheirProgramAndTheirSeedAlone) {
  const std::string drawn_depth =
      "[[input]]\nname = \"fill_depth\"\nhalf_width = 0.0005\nunit = \"m\"\nsource = \"a "
      "ruler\"\n";
  struct Change {
    std::string from, of_air, of_cells;  // without `from` the key is added
  };
  for (const Change& change : std::vector<Change>{
           {"cells_x = 20", "cells_x = 20", "cells_x = 30"},
           {"cells_z = 20", "cells_z = 20", "cells_z = 30"},
           {"start_disorder = 0.1", "start_disorder = 0.1", "start_disorder = 0.05"},
           {"", "no wall_cell_m", "wall_cell_m = 0.04"},
           {"", "courant_number = 0.5", "courant_number = 0.25"},
           {"", "interface_courant_number = 0.5", "interface_courant_number = 0.25"},
           {"", "no_slip = false", "no_slip = true"},
           {"", "processes = 1", "processes = 2"},
           {"", "vary_inputs = false", "vary_inputs = true"}}) {
    const std::string said =
        change.from.empty()
            ? complaint_with_run("cells", "repeats = 3", "repeats = 3\n" + change.of_cells,
                                 drawn_depth)
            : complaint_with_run("cells", change.from, change.of_cells, drawn_depth);
    EXPECT_TRUE(holds(said,
                      "compressibility = \"cells\": expected a run that differs from air in its "
                      "program, its seed and its outer_corrections alone, with " +
                          change.of_air + "; it has " + change.of_cells))
        << said;
  }
  EXPECT_EQ(complaint_with_run("cells", "repeats = 3", "repeats = 4\nstart_seed = 7"), "");
  EXPECT_EQ(complaint_with_run("cells", "repeats = 3", "repeats = 3\nquick = true"), "");
  EXPECT_EQ(complaint_with_run("cells", "repeats = 3", "repeats = 3\nouter_corrections = 2"), "");
  EXPECT_EQ(complaint_with_run("particles", "start_disorder = 0.1", "start_disorder = 0.05"), "");
}

TEST(PanelSection, NeedsAReasonAndANameOfItsOwn) {
  EXPECT_TRUE(holds(complaint_with("reason = \"a reason\"\n", ""), "reason"));
  const Workspace workspace;
  EXPECT_TRUE(holds(complaint(workspace.write("trial.toml", valid_text + runs + panel + panel)),
                    "a name that no other panel has"));
}

}  // namespace
}  // namespace slosh::panel_section_test
