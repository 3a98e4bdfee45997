#include "reports/figures/run_looks.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <tuple>

#include "reports/model/is_one_of.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

constexpr std::size_t hues = 6, shapes = 10;

// A family's hue, and the marker and dash of its finest run.
struct FamilyLook {
  std::string_view family;
  std::size_t hue, shape;

  bool is_alike(const FamilyLook& other) const { return hue == other.hue && shape == other.shape; }
};

// The families of the shipped cases. There are more than hues that the colour-blind tell apart:
// those that share a hue have other markers, filled and hollow.
constexpr FamilyLook known_families[] = {
    {"recommended", 0, 0},     {"interFoam", 1, 1},        {"li2010", 2, 2},
    {"zhao2021_moving", 3, 3}, {"zhao2021_fixed", 4, 4},   {"delta_sph", 5, 5},
    {"interIsoFoam", 1, 6},    {"pysph_delta_sph", 3, 8},  {"pysph_edac", 4, 9},
    {"pysph_adami", 5, 8},     {"dualsphysics_mdbc", 2, 7}};

const FamilyLook* known_look(std::string_view family) {
  const auto found = std::find_if(std::begin(known_families), std::end(known_families),
                                  [&](const FamilyLook& known) { return known.family == family; });
  return found == std::end(known_families) ? nullptr : &*found;
}

// The first look that none of these has: of a hue that none of them has, else of any.
FamilyLook free_look(const std::string& family, const std::vector<FamilyLook>& taken) {
  const auto is_none = [&](const auto& is_like) {
    return std::none_of(taken.begin(), taken.end(), is_like);
  };
  for (std::size_t hue = 0; hue < hues; ++hue)
    if (is_none([&](const FamilyLook& one) { return one.hue == hue; })) return {family, hue, hue};
  for (std::size_t shape = 0; shape < shapes; ++shape)
    for (std::size_t hue = 0; hue < hues; ++hue) {
      const FamilyLook look{family, hue, (hue + shape) % shapes};
      if (is_none([&](const FamilyLook& one) { return one.is_alike(look); })) return look;
    }
  return {family, 0, 0};  // more than 60 families
}

// The look of a family among others: its own where it is known, else one that no known family and
// no earlier one has.
FamilyLook look_among(const std::string& family, const std::vector<std::string>& families) {
  if (const FamilyLook* known = known_look(family)) return *known;
  std::vector<FamilyLook> taken;
  for (const std::string& one : families)
    if (const FamilyLook* known = known_look(one)) taken.push_back(*known);
  for (const std::string& one : families) {
    if (one == family) break;
    if (!known_look(one)) taken.push_back(free_look(one, taken));
  }
  return free_look(family, taken);
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (!is_one_of(name, names)) names.push_back(name);
}

// Returns how many runs of the family, an ensemble as one, come before the run: those with less of
// the scheme changed, the finer ones, and those that the case names earlier.
std::size_t rank_of(const CaseDefinition& definition, const RunDefinition& run) {
  const auto order = [](const RunDefinition& one) {
    return std::tuple{is_changed(one), -resolution(one)};
  };
  std::size_t rank = 0;
  bool is_earlier = true;
  for (const RunDefinition& other : definition.runs) {
    is_earlier = is_earlier && other.name != run.name;
    if (is_simulation(other) && !is_later_member(other) && family(other) == family(run))
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
  const FamilyLook own = look_among(family(run), families);
  return {false, own.hue, own.shape + rank_of(definition, run)};
}

reports::Look look_of_family(const CaseDefinition& definition, const std::string& name) {
  const RunDefinition* first = nullptr;
  for (const RunDefinition& run : definition.runs)
    if (is_simulation(run) && family(run) == name && (!first || rank_of(definition, run) == 0))
      first = &run;
  if (first) return look_of(definition, first->name);
  const FamilyLook mesh = look_among("interFoam", {});
  return {false, mesh.hue, mesh.shape};
}

std::vector<reports::Look> looks_of_models(const std::vector<std::string>& models) {
  const auto family_of = [](const std::string& model) { return model.substr(0, model.find(", ")); };
  std::vector<std::string> families;
  for (const std::string& model : models) add_once(family_of(model), families);
  std::vector<reports::Look> looks;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const FamilyLook own = look_among(family_of(models[i]), families);
    const auto before = std::count_if(
        models.begin(), models.begin() + static_cast<long>(i),
        [&](const std::string& other) { return family_of(other) == family_of(models[i]); });
    looks.push_back({false, own.hue, own.shape + static_cast<std::size_t>(before)});
  }
  return looks;
}

}  // namespace slosh
