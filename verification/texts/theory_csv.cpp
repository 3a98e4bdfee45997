#include "verification/texts/theory_csv.hpp"

#include <fmt/format.h>

#include "verification/texts/series_csv.hpp"

namespace slosh {
namespace {

// A text may have several lines.
std::string comment(const std::string& text) {
  std::string lines = "# ";
  for (const char letter : text) lines += letter == '\n' ? "\n# " : std::string(1, letter);
  return lines + "\n";
}

}  // namespace

std::string theory_line(const TheoryRemarks& remarks) {
  return remarks.outside
             ? fmt::format("{} is outside its range: it {}", remarks.run, *remarks.outside)
             : fmt::format("{} is inside its range: {}", remarks.run, remarks.range);
}

std::string theory_csv(const CaseDefinition& definition, const CaseTheories& theories) {
  std::string text = comment(fmt::format("Case {}: {}", definition.name, definition.title)) +
                     comment("Source: " + definition.source);
  for (const TheoryRemarks& remarks : theories.remarks) {
    text += comment(fmt::format("{}: {}", remarks.run, remarks.solution));
    text += comment(fmt::format("{}, range: {}", remarks.run, remarks.range));
    if (remarks.outside) text += comment(theory_line(remarks));
    text += comment(fmt::format("{}, uncertainty: {}", remarks.run, remarks.uncertainty));
  }
  return text + series_csv(theories.result);
}

}  // namespace slosh
