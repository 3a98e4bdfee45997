#include "verification/solvers/solver_runs.hpp"

#include <fmt/format.h>

#include <variant>

namespace slosh {

CaseFileError refused(const RunDefinition& run, const std::string& why) {
  return CaseFileError(
      fmt::format("{}:{}: run {}: {}", run.where.file, run.where.line, run.name, why));
}

void require_scene(const CaseDefinition& definition, const RunDefinition& run) {
  std::visit([&](const auto& solver) { require_scene(solver, definition, run); }, run.solver);
}

RunResult run_solver(const RunRequest& request) {
  return std::visit([&](const auto& solver) { return run_solver(solver, request); },
                    request.run.solver);
}

}  // namespace slosh
