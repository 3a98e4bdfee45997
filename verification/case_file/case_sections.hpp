// The sections of a case file. Private to case_parser.cpp.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

// [tank]; [liquid] and [gas], of what has been read before them.
TankDefinition read_tank(const TomlTable& tank);
LiquidDefinition read_liquid(const TomlTable& liquid, const TankDefinition& tank);
GasDefinition read_gas(const TomlTable& gas, const LiquidDefinition& liquid);

// [time]; and [comparison], of a case whose gravity, liquid, motion and initial wave have been
// read.
void read_time(const TomlTable& time, CaseDefinition& definition);
void read_comparison(const TomlTable& comparison, CaseDefinition& definition);

// [motion], of a case whose tank and duration have been read; the tables' files are relative to the
// case file.
MotionDefinition read_motion(const TomlTable& motion, const CaseDefinition& definition);

// [[gauge]] and [[pressure_gauge]], of a case whose tank and sample interval have been read.
GaugeDefinition read_gauge(const TomlTable& gauge, const CaseDefinition& definition);
PressureGaugeDefinition read_pressure_gauge(const TomlTable& gauge,
                                            const CaseDefinition& definition);

// [impacts], of a case whose duration and gauges have been read; the repeats' table lies below that
// directory, which may be empty.
ImpactsDefinition read_impacts(const TomlTable& impacts, const CaseDefinition& definition,
                               const std::filesystem::path& experiments);

// [[obstacle]], of a case whose tank, liquid and gauges have been read.
ObstacleDefinition read_obstacle(const TomlTable& obstacle, const CaseDefinition& definition);

// No two of the obstacles, read from these tables, may overlap: they may touch.
void refuse_overlaps(const std::vector<TomlTable>& tables,
                     const std::vector<ObstacleDefinition>& obstacles);

// [initial_wave], of a case whose tank, liquid and obstacles have been read.
InitialWaveDefinition read_initial_wave(const TomlTable& wave, const CaseDefinition& definition);

// [animation], of a case whose time has been read: its moments [s].
std::vector<double> read_animation(const TomlTable& animation, const CaseDefinition& definition);

// [[run]], of a case whose liquid, motion and gauges have been read: one run, or with repeats as
// many (ensemble.hpp). The files of records are relative to the case file, those of experiments to
// that directory, which may be empty.
std::vector<RunDefinition> read_runs(const TomlTable& run, const CaseDefinition& definition,
                                     const std::filesystem::path& experiments);

// The keys of [[run]] with solver = "external"; its files are relative to the case file.
ExternalRun read_external_run(const TomlTable& run, const CaseDefinition& definition);

// [[refinement]], of a case whose runs have been read.
RefinementDefinition read_refinement(const TomlTable& refinement, const CaseDefinition& definition);

// [[input]], of a case whose motion and earlier inputs have been read.
InputUncertainty read_input(const TomlTable& table, const CaseDefinition& definition);

// [[gate]], of a case whose motion, gauges, comparison and runs have been read.
GateRow read_gate_row(const TomlTable& row, const CaseDefinition& definition);

}  // namespace slosh
