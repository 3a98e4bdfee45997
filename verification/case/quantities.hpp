// The table of recorded quantities: the series on which the runs of a case are compared, and all
// that is known of each. A new quantity is a row here, beside the solver that records it and the
// place where the solver's output becomes series (results/taken_series.hpp, solvers/*_run.cpp).
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// A quantity that is measured at gauges, probes or walls has one series for each.
enum class MeasuredAt { tank, surface_gauge, pressure_gauge, probe, wall };

struct Quantity {
  const char* name;  // of the series; elsewhere than in the tank "@" and the place's name follow
  const char* unit;  // SI
  MeasuredAt at;
  // Whether the runs of a case may have it; null: those of every case.
  bool (*exists_in)(const CaseDefinition&) = nullptr;
  // Whether it oscillates in the modes of linear theory, so that these can be fitted to it. A front
  // only advances, and vertical force and momentum are of second order.
  bool has_modes = false;
  // Whether declaring a gauge requests it: a run without it is reported. Any other quantity is
  // compared where both runs recorded it.
  bool is_gauged = false;
  const char* amplitude = "";  // the amplitude in tables of predictions; empty: not predicted
  // How figures show it: the title, which the place of a gauge follows; the axis label; the unit
  // there, and its ratio to SI.
  const char* title = "";
  const char* label = "";
  const char* shown_unit = "";
  double shown_per_si = 1;
  // The axis label of a history over the still depth and the forcing period; null: a history has
  // dimensions.
  const char* label_over_depth = nullptr;
  // Sentences of captions: what exactly is measured, and how each kind of run obtains it.
  const char* meaning = "";
  const char *sph = "", *interfoam = "", *theory = "";
  bool tells_sampling = false;  // whether a caption tells the sampling and the filter
};

// In the order in which a case compares them.
const std::vector<Quantity>& quantity_table();

// Returns the row of a series "elevation@right", "wall_pressure@B/filtered", "force_x", ...; null
// where the series is no compared quantity.
const Quantity* find_quantity(const std::string& series);

// Returns the series that any run of the case may have, the case's main one first. A pressure
// gauge with a filter has a second series, NAME@GAUGE/filtered.
std::vector<std::string> compared_quantities(const CaseDefinition& definition);

// The suffix of a pressure through a gauge's filter.
inline constexpr const char* through_filter = "/filtered";

// Whether it is a filtered pressure; the edges of its band are not.
bool is_filtered(const std::string& series);

// Returns "wall_pressure@B" for the gauge B.
std::string wall_pressure(const std::string& gauge);

// Returns "wall_pressure@B/filtered" where the gauge has a filter, else "wall_pressure@B".
std::string smoothest_pressure(const PressureGaugeDefinition& gauge);

// Returns the pressure at the gauge of [impacts] and, if the gauge has a filter, the filtered
// pressure. Throws std::bad_optional_access for a case without [impacts].
std::vector<std::string> impact_pressures(const CaseDefinition& definition);

// Throws std::invalid_argument for a series that is no compared quantity.
std::string unit_of(const std::string& series);

// A value in this unit that no quantity of the case exceeds: of a length the tank's larger side, of
// a speed ten times U = sqrt(2 g (L + H)) + the tank's own largest speed, of a pressure the water
// hammer rho c U with c = 1500 m/s, of loads that over the tank's sides, of a momentum the liquid's
// at 10 U. 1e9 in any other unit.
double largest_in_tank(const CaseDefinition& definition, const std::string& unit);

// Returns the values at which a series may stay without being cut off: the bottom and the roof of
// the tank and its obstacles of a surface, the end wall of a front, zero of what falls dry. The
// section of an outline is that of its corners.
std::vector<double> resting_values(const CaseDefinition& definition, const std::string& series);

// Returns all names of the table, with "@GAUGE", "@PROBE" and "@WALL" for the quantities of gauges,
// probes and walls.
std::vector<std::string> quantity_names();

// Return false for a series that is no compared quantity.
bool has_modes(const std::string& series);
bool is_gauged(const std::string& series);

// The suffixes of what a theory leaves beside its series: the same flow with fewer nodes, with more
// modes, and with an estimate of what linear theory leaves out (SolverKind::leaves).
inline constexpr const char *coarser = "/coarser", *finer = "/finer", *nonlinear = "/nonlinear";
// The suffixes of the edges of a record's band.
inline constexpr const char *lower_edge = "/lower", *upper_edge = "/upper";

// Returns the numbers of the first `count` natural modes that linear theory excites, lowest first:
// those that the tank's motion excites, which are the odd ones of a symmetric tank, and that of the
// initial wave. In a still tank the initial wave's mode is the only one. In a rectangle a mode's
// number is that of the half waves between the walls.
std::vector<int> natural_modes(const CaseDefinition& definition, int count);

}  // namespace slosh
