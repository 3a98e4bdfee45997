#include "verification/solvers/solver_runs.hpp"

#include <fmt/format.h>

#include <variant>

namespace slosh {
namespace {

const char* solver_name(const SphRun&) { return "sph"; }
const char* solver_name(const InterFoamRun&) { return "interfoam"; }
const char* solver_name(const LinearRun&) { return "linear"; }
const char* solver_name(const PotentialRun&) { return "potential"; }
const char* solver_name(const ViscousWaveRun&) { return "viscous_wave"; }
const char* solver_name(const RecordRun&) { return "record"; }
const char* solver_name(const ExternalRun&) { return "external"; }

RunResult run_solver(const SphRun& run, const RunRequest& request) { return run_sph(run, request); }
RunResult run_solver(const InterFoamRun& run, const RunRequest& request) {
  return run_interfoam(run, request);
}
RunResult run_solver(const LinearRun& run, const RunRequest& request) {
  return run_linear(run, request);
}
RunResult run_solver(const PotentialRun& run, const RunRequest& request) {
  return run_potential(run, request);
}
RunResult run_solver(const ViscousWaveRun&, const RunRequest& request) {
  return run_viscous_wave(request);
}
RunResult run_solver(const RecordRun& run, const RunRequest& request) {
  return run_record(run, request);
}
RunResult run_solver(const ExternalRun& run, const RunRequest& request) {
  return run_external(run, request);
}

}  // namespace

std::string solver_name(const RunDefinition& run) {
  return std::visit([](const auto& solver) -> std::string { return solver_name(solver); },
                    run.solver);
}

CaseFileError refused(const RunDefinition& run, const std::string& why) {
  return CaseFileError(
      fmt::format("{}:{}: run {}: {}", run.where.file, run.where.line, run.name, why));
}

void require_scene(const CaseDefinition& definition, const RunDefinition& run) {
  std::visit([&](const auto& solver) { require_scene(solver, definition, run); }, run.solver);
}

RunResult run_solver(const RunRequest& request) {
  return std::visit([&](const auto& run) { return run_solver(run, request); }, request.run.solver);
}

}  // namespace slosh
