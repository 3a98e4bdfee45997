#include <fmt/format.h>

#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

// Fewer are no motion; more make a page that takes long to load.
constexpr long fewest_moments = 3, most_moments = 60;

Rule<double> sampled(const CaseDefinition& definition) {
  return {
      fmt::format("a number > 0 and <= the duration ({}), a multiple of sample_interval_s ({}), "
                  "in s",
                  definition.duration, definition.sample_interval),
      [&definition](double value) {
        const double samples = value / definition.sample_interval;
        return value > 0 && value <= definition.duration &&
               std::abs(samples - std::round(samples)) <= 1e-9 * samples;
      }};
}

}  // namespace

std::vector<double> read_animation(const TomlTable& animation, const CaseDefinition& definition) {
  animation.allow_only(keys_of("animation"));
  const Rule<double> rule = sampled(definition);
  const double begin = animation.get("begin_s", rule), end = animation.get("end_s", rule),
               interval = animation.get("interval_s", rule);
  const long moments = std::lround(std::floor((end - begin) / interval + 1e-9)) + 1;
  if (!(moments >= fewest_moments && moments <= most_moments))
    animation.refuse("interval_s",
                     fmt::format("a number that makes {} to {} moments from begin_s to end_s, in s",
                                 fewest_moments, most_moments));
  std::vector<double> times;
  const double first = std::round(begin / definition.sample_interval),
               stride = std::round(interval / definition.sample_interval);
  for (long i = 0; i < moments; ++i)
    times.push_back((first + static_cast<double>(i) * stride) * definition.sample_interval);
  return times;
}

}  // namespace slosh
