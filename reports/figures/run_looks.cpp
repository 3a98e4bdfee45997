#include "reports/figures/run_looks.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include "reports/model/is_one_of.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

// The families of the shipped cases, in the order of the hues.
constexpr std::array<std::string_view, 6> known_families{
    "recommended", "interFoam", "li2010", "zhao2021_moving", "zhao2021_fixed", "delta_sph"};

// A family that is not known takes a hue that no known family among `families` has, in their order.
std::size_t hue_of(const std::string& family, const std::vector<std::string>& families) {
  const auto known = std::find(known_families.begin(), known_families.end(), family);
  if (known != known_families.end())
    return static_cast<std::size_t>(known - known_families.begin());
  std::vector<std::size_t> free;
  for (std::size_t hue = 0; hue < known_families.size(); ++hue)
    if (!is_one_of(known_families[hue], families)) free.push_back(hue);
  std::size_t number = 0;
  for (const std::string& other : families) {
    if (other == family) break;
    number += !is_one_of(other, known_families);
  }
  return free.empty() ? number : free[number % free.size()];
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (!is_one_of(name, names)) names.push_back(name);
}

// Returns how many runs of the family come before the run: those with less of the scheme changed,
// the finer ones, and those that the case names earlier.
std::size_t rank_of(const CaseDefinition& definition, const RunDefinition& run) {
  const auto order = [](const RunDefinition& one) {
    return std::tuple{is_changed(one), -resolution(one)};
  };
  std::size_t rank = 0;
  bool is_earlier = true;
  for (const RunDefinition& other : definition.runs) {
    is_earlier = is_earlier && other.name != run.name;
    if (is_simulation(other) && family(other) == family(run))
      rank += order(other) < order(run) || (is_earlier && order(other) == order(run));
  }
  return rank;
}

}  // namespace

reports::Look look_of(const CaseDefinition& definition, const std::string& name) {
  const RunDefinition& run = run_named(definition, name);
  std::vector<std::string> families;
  std::size_t references_before = 0;
  bool is_earlier = true;
  for (const RunDefinition& other : definition.runs) {
    is_earlier = is_earlier && other.name != name;
    if (is_simulation(other))
      add_once(family(other), families);
    else
      references_before += is_earlier;
  }
  if (!is_simulation(run)) return {true, references_before, references_before / 2};
  const std::size_t hue = hue_of(family(run), families);
  return {false, hue, hue + rank_of(definition, run)};
}

reports::Look look_of_family(const CaseDefinition& definition, const std::string& name) {
  const RunDefinition* first = nullptr;
  for (const RunDefinition& run : definition.runs)
    if (is_simulation(run) && family(run) == name && (!first || rank_of(definition, run) == 0))
      first = &run;
  if (first) return look_of(definition, first->name);
  const std::size_t hue = hue_of("interFoam", {});
  return {false, hue, hue};
}

std::vector<reports::Look> looks_of_models(const std::vector<std::string>& models) {
  const auto family_of = [](const std::string& model) { return model.substr(0, model.find(", ")); };
  std::vector<std::string> families;
  for (const std::string& model : models) add_once(family_of(model), families);
  std::vector<reports::Look> looks;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::size_t hue = hue_of(family_of(models[i]), families);
    const auto before = std::count_if(
        models.begin(), models.begin() + static_cast<long>(i),
        [&](const std::string& other) { return family_of(other) == family_of(models[i]); });
    looks.push_back({false, hue, hue + static_cast<std::size_t>(before)});
  }
  return looks;
}

}  // namespace slosh
