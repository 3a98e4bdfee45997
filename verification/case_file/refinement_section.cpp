#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "verification/case/ensemble.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

constexpr std::pair<const char*, RefinedNumber> numbers[] = {
    {"particle_spacing", RefinedNumber::particle_spacing},
    {"smoothing_length_ratio", RefinedNumber::smoothing_length_ratio},
    {"speed_of_sound", RefinedNumber::speed_of_sound},
    {"courant_number", RefinedNumber::courant_number},
    {"mesh", RefinedNumber::mesh}};

RefinedNumber read_number(const TomlTable& refinement) {
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers) names.push_back(name);
  const std::string given = refinement.choice("number", "what the runs refine", names);
  for (const auto& [name, number] : numbers)
    if (given == name) return number;
  throw CaseFileError("a refined number without a name");
}

// The run with the refined number taken out.
SphRun without(SphRun run, RefinedNumber number) {
  switch (number) {
    case RefinedNumber::particle_spacing:
      run.particle_spacing = run.surface_particle_spacing = 0;
      break;
    case RefinedNumber::smoothing_length_ratio:
      run.numbers.smoothing_length_ratio.reset();
      break;
    case RefinedNumber::speed_of_sound:
      run.numbers.sound_speed_ratio.reset();
      break;
    case RefinedNumber::courant_number:
      run.numbers.courant_number.reset();
      break;
    case RefinedNumber::mesh:
      break;
  }
  run.energy_budget = false;  // is only recorded
  return run;
}

bool are_alike(const RunDefinition& one, const RunDefinition& other, RefinedNumber number) {
  const auto* a = std::get_if<SphRun>(&one.solver);
  const auto* b = std::get_if<SphRun>(&other.solver);
  return a && b && without(*a, number) == without(*b, number);
}

std::vector<std::string> runs_of(const CaseDefinition& definition, bool of_mesh) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (!is_later_member(run) && (of_mesh ? std::holds_alternative<InterFoamRun>(run.solver)
                                          : std::holds_alternative<SphRun>(run.solver)))
      names.push_back(run.name);
  return names;
}

}  // namespace

RefinementDefinition read_refinement(const TomlTable& refinement,
                                     const CaseDefinition& definition) {
  refinement.allow_only(keys_of("refinement"));
  RefinementDefinition path;
  path.name = refinement.get("name", file_safe_name());
  path.number = read_number(refinement);
  const bool of_mesh = path.number == RefinedNumber::mesh;
  const std::vector<std::string> known = runs_of(definition, of_mesh);
  for (const PlacedText& run : refinement.texts("runs", any_text())) {
    if (std::find(known.begin(), known.end(), run.text) == known.end())
      refinement.refuse("runs", fmt::format("{} runs of this case, which {} is not",
                                            of_mesh ? "interFoam" : "SPH", run.text));
    if (std::find(path.runs.begin(), path.runs.end(), run.text) != path.runs.end())
      refinement.refuse("runs", fmt::format("each run once, {} is there twice", run.text));
    if (!path.runs.empty() && !of_mesh &&
        !are_alike(run_named(definition, path.runs.front()), run_named(definition, run.text),
                   path.number))
      refinement.refuse("runs",
                        fmt::format("runs that are alike but for the refined number, {} and {} are "
                                    "not",
                                    path.runs.front(), run.text));
    path.runs.push_back(run.text);
  }
  if (path.runs.size() < 2) refinement.refuse("runs", "two runs or more");
  return path;
}

}  // namespace slosh
