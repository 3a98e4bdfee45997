// The metrics of the gate, in one table: the name in case files and at the command line, the unit,
// what each is measured on, and how wide a bound on it may be. The parser of gate rows, the option
// --limit of compare, and whoever names a metric or its unit read this table.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/rules.hpp"

namespace slosh {

enum class MeasuredOn {
  any_mode,
  natural_mode,  // not on a forced one, whose frequency is given and which does not decay: a row
                 // there would pass whatever the candidate did
  whole_window,
  wave,        // the whole window of a quantity with modes: what counts periods or peaks
  run_away,    // the whole window of a quantity without modes: modes have lags of their own
  own_series,  // the candidate alone
  impact,
  plateau,
  cost  // of the candidate's family
};

// What `below` is a multiple of.
enum class BoundScale { unit, window, impact_period };

struct MetricEntry {
  Metric metric;
  const char* name;
  const char* unit;  // "": the quantity's
  MeasuredOn measured_on;
  // A limit, and half the width of a range, lie below this many of the scale; the reason says what
  // a wider bound would let pass.
  double below;
  BoundScale scale;
  const char* because;
};

const std::vector<MetricEntry>& metric_table();
const MetricEntry& metric_entry(Metric metric);
// Of a name that the table has.
const MetricEntry& metric_entry(const std::string& name);

std::string metric_name(Metric metric);
std::string metric_unit(Metric metric, const std::string& quantity_unit);

// Whether a comparison of one candidate with one reference gives the metric.
bool is_of_a_pair(const MetricEntry& metric);
bool is_of_impacts(Metric metric);

// The modes of a GateRow on which a metric can be judged. `fitted`: the modes that are fitted to
// the quantity, "forced", "natural_1", ...; `runs_away`: the quantity has no modes. Of impacts
// none: the case names those.
std::vector<std::string> measured_modes(const MetricEntry& metric,
                                        const std::vector<std::string>& fitted, bool runs_away);
// "what phase_lag is measured on"
std::string measured_on_text(const MetricEntry& metric);

// [s], of the comparison's window and of the motion that brings the impacts.
struct BoundScales {
  double window;
  double impact_period = 0;
};

// The width from which on a bound on the metric lets everything pass, in its unit.
double widest_bound(const MetricEntry& metric, const BoundScales& scales);
// What a limit on the metric must be: above 0 and below widest_bound().
Rule<double> limit_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales);

}  // namespace slosh
