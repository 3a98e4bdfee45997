// The runs of one method of an external program, or of stored results: what they have in common.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <tuple>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// By its suffix, or by how it begins. The bit of a file that can be executed tells nothing where a
// disk gives it to all files.
bool is_program(const fs::path& file) {
  static constexpr std::array<std::string_view, 11> suffixes{
      ".py", ".sh", ".R", ".jl", ".m", ".pl", ".rb", ".lua", ".js", ".jar", ".exe"};
  if (std::ranges::count(suffixes, file.extension().string()) > 0) return true;
  std::error_code lost;
  if (!fs::is_regular_file(file, lost)) return false;
  std::string head(4, ' ');
  std::ifstream(file, std::ios::binary).read(head.data(), std::ssize(head));
  return head.starts_with("#!") || head ==
                                       "\x7f"
                                       "ELF";
}

// The names of the programs and scripts in a command: each spacing may have a directory of its own.
std::vector<std::string> programs_of(const ExternalRun& external,
                                     const CaseDefinition& definition) {
  const std::string here = "{case_directory}/";
  std::vector<std::string> names{fs::path(external.command.front()).filename().string()};
  for (auto word = external.command.begin() + 1; word != external.command.end(); ++word) {
    const fs::path file = word->starts_with(here) ? word->substr(here.size()) : *word;
    if (is_program(definition.file.parent_path() / file) ||
        (!external.directory.empty() && is_program(external.directory / file)))
      names.push_back(file.filename().string());
  }
  return names;
}

bool takes_alike(const SeriesSource& one, const SeriesSource& other) {
  const auto how = [](const SeriesSource& source) {
    return std::tie(source.format, source.column, source.unit, source.time_column, source.time_unit,
                    source.scale, source.offset, source.time_offset, source.first_is_zero,
                    source.whole_tank);
  };
  return how(one) == how(other);
}

// What two runs of a method take in different ways; empty where that is nothing.
template <class Run>
std::string taken_otherwise(const Run& run, const Run& other) {
  for (const SeriesSource& one : run.series)
    for (const SeriesSource& same : other.series)
      if (one.quantity == same.quantity && !takes_alike(one, same))
        return fmt::format("takes {} with the same format, column, unit, scale, offset and datum",
                           one.quantity);
  return "";
}

// What else than the spacing differs between two runs of a method; empty where that is nothing.
// Their settings may differ, which can be how a program gets its spacing.
std::string other_difference(const RunDefinition& run, const RunDefinition& other,
                             const CaseDefinition& definition) {
  if (const auto* a = std::get_if<StoredRun>(&run.solver),
      *b = std::get_if<StoredRun>(&other.solver);
      a && b)
    return taken_otherwise(*a, *b);
  const auto *a = std::get_if<ExternalRun>(&run.solver),
             *b = std::get_if<ExternalRun>(&other.solver);
  if (!a || !b) return "";
  const std::vector<std::string> programs = programs_of(*b, definition);
  if (programs_of(*a, definition) != programs)
    return fmt::format("starts the same programs, {}", fmt::join(programs, " "));
  const bool names_spacing =
      fmt::format("{}", fmt::join(a->command, " ")).find("{particle_spacing_m}") !=
      std::string::npos;
  if (a->command == b->command && a->directory == b->directory && !names_spacing)
    return "has another command or directory, as by {particle_spacing_m}";
  return taken_otherwise(*a, *b);
}

}  // namespace

void refuse_shared_method(const TomlTable& table, const RunDefinition& run,
                          const CaseDefinition& definition) {
  const std::string method = method_of(run);
  for (const RunDefinition& other : definition.runs) {
    if (family(other) != family(run) || (method.empty() && method_of(other).empty())) continue;
    if (method != method_of(other))
      table.refuse(table.has("scheme") ? "scheme"
                   : !method.empty()   ? "method"
                                       : "name",
                   fmt::format("a name that does not stand for the run {} too", other.name));
    if (particle_spacing(other) == particle_spacing(run))
      table.refuse("particle_spacing_m",
                   fmt::format("a spacing that no other run of the method has; {} has this one",
                               other.name));
    if (const std::string same = other_difference(run, other, definition); !same.empty())
      table.refuse("method", fmt::format("a run that differs from {} in the spacing alone, and {}",
                                         other.name, same));
  }
}

}  // namespace slosh
