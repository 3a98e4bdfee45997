#include "verification/case/ensemble.hpp"

#include <fmt/format.h>

#include <set>

namespace slosh {
namespace {

int& seed_of(RunDefinition& run) {
  return std::visit(
      [](auto& solver) -> int& {
        if constexpr (requires { solver.start_seed; })
          return solver.start_seed;
        else
          throw std::bad_variant_access();  // the case parser gives such a run no repeats
      },
      run.solver);
}

}  // namespace

std::vector<RunDefinition> ensemble_of(const RunDefinition& first, int repeats, int quick_repeats) {
  std::vector<RunDefinition> members;
  for (int k = 0; k < repeats; ++k) {
    RunDefinition member = first;
    member.ensemble = first.name;
    member.quick = first.quick && k < quick_repeats;
    seed_of(member) += k;
    if (k > 0) member.name = fmt::format("{}_{}", first.name, k + 1);
    members.push_back(std::move(member));
  }
  return members;
}

int start_seed(const RunDefinition& run) {
  RunDefinition copy = run;
  return seed_of(copy);
}

bool is_later_member(const RunDefinition& run) {
  return !run.ensemble.empty() && run.ensemble != run.name;
}

std::vector<std::string> members_of(const CaseDefinition& definition, const std::string& run) {
  std::vector<std::string> members;
  for (const RunDefinition& one : definition.runs)
    if (one.name == run || one.ensemble == run) members.push_back(one.name);
  return members;
}

void keep_quick_members(CaseDefinition& definition) {
  std::set<std::string> quick;
  for (const RunDefinition& run : definition.runs)
    if (run.quick) quick.insert(run.ensemble);
  std::erase_if(definition.runs, [&](const RunDefinition& run) {
    return is_later_member(run) && !run.quick && quick.contains(run.ensemble);
  });
}

}  // namespace slosh
