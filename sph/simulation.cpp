#include "sph/simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <stdexcept>

#include "sph/scheme_runs.hpp"
#include "sph/threads.hpp"

namespace slosh::sph {
namespace {

using Run = RunOutput (*)(const Scene&, const Progress&);

template <class... Choices>
std::map<std::string, Run> runs_of(ChoiceList<Choices...>) {
  return {{Choices::variant, &run_scheme<Choices>}...};
}

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& table) {
  std::vector<std::string> names;
  for (const auto& [name, value] : table) names.push_back(name);
  return names;
}

const std::map<std::string, Run>& schemes() {
  static const std::map<std::string, Run> table{{"li2010", &run_scheme<Li2010>},
                                                {"delta_sph", &run_scheme<DeltaSph>},
                                                {"recommended", &run_scheme<Recommended>},
                                                {"zhao2021_moving", &run_scheme<Zhao2021Moving>},
                                                {"zhao2021_fixed", &run_scheme<Zhao2021Fixed>}};
  return table;
}

// What takes the place of a scheme or a variant where the tank rolls, whose walls would have to
// turn: the same in the tank's frame.
const std::map<std::string, Run>& rolling() {
  static const std::map<std::string, Run> table{
      {"li2010", &run_scheme<InTank<Li2010>>},
      {"delta_sph", &run_scheme<InTank<DeltaSph>>},
      {"recommended", &run_scheme<InTank<Recommended>>},
      {WithRepulsiveWalls::variant, &run_scheme<InTank<WithRepulsiveWalls>>}};
  return table;
}

const std::map<std::string, Run>& variants() {
  static const std::map<std::string, Run> table = runs_of(Variants{});
  return table;
}

Run named(const std::map<std::string, Run>& table, const char* what, const std::string& name) {
  const auto found = table.find(name);
  if (found == table.end())
    throw std::invalid_argument(fmt::format("{} = \"{}\": expected one of {}", what, name,
                                            fmt::join(names_of(table), " | ")));
  return found->second;
}

Run chosen(const std::string& scheme, const Scene& scene) {
  const Run run = named(schemes(), "scheme", scheme);
  const auto turned = rolling().find(scene.variant.empty() ? scheme : scene.variant);
  const bool uniform = scene.surface_particle_spacing == scene.particle_spacing;
  if (!scene.variant.empty() && scheme != "recommended")
    throw std::invalid_argument(fmt::format(
        "variant = \"{}\": expected none, only recommended has variants", scene.variant));
  if (!uniform && scene.variant != WithTwoSpacings::variant && (scheme != "li2010" || scene.roll))
    throw std::invalid_argument("scheme " + scheme +
                                " takes one particle spacing: surface_particle_spacing differs");
  if (!uniform && scheme == "li2010") return &run_scheme<Li2010TwoSpacings>;
  if (scene.roll && turned != rolling().end()) return turned->second;
  return scene.variant.empty() ? run : named(variants(), "variant", scene.variant);
}

std::size_t particles_in(const Scene& scene) {
  const double width = scene.column_width.value_or(scene.tank_length);
  return static_cast<std::size_t>(width * scene.fill_depth /
                                  (scene.particle_spacing * scene.particle_spacing));
}

}  // namespace

std::vector<std::string> scheme_names() { return names_of(schemes()); }

std::vector<std::string> variant_names() { return names_of(variants()); }

RunOutput run(const std::string& scheme, const Scene& scene, const Progress& progress) {
  const Run method = chosen(scheme, scene);
  const ThreadScope threads(scene.threads.value_or(threads_for(particles_in(scene))));
  return method(scene, progress);
}

}  // namespace slosh::sph
