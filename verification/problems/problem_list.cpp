#include "verification/problems/problem_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "verification/input/nearest_name.hpp"

namespace slosh {

const std::vector<Problem>& all_problems() {
  static const std::vector<Problem> problems{
      taylor_green_problem(),  oscillating_drop_problem(), rigid_rotation_problem(),
      courant_map_problem(),   viscosity_map_problem(),    gamma_map_problem(),
      diffusion_map_problem(), lattice_buckling_problem(), lattice_resistance_problem()};
  return problems;
}

const Problem& find_problem(const std::string& name) {
  const std::vector<Problem>& problems = all_problems();
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const Problem& one) { return one.name == name; });
  if (found != problems.end()) return *found;
  std::vector<std::string> names;
  for (const Problem& one : problems) names.push_back(one.name);
  throw std::invalid_argument(fmt::format("problem = \"{}\": expected one of {}; nearest: {}", name,
                                          fmt::join(names, ", "),
                                          nearest_names(name, names, 1).front()));
}

std::vector<KnownProblem> known_problems() {
  std::vector<KnownProblem> known;
  for (const Problem& one : all_problems()) {
    known.push_back({one.name, {}});
    for (const MeasureKind& kind : one.measures)
      known.back().measures.push_back({kind.name, kind.unit});
  }
  return known;
}

}  // namespace slosh
