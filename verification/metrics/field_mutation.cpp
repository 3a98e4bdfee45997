#include "verification/metrics/field_mutation.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr std::uint64_t field_noise_seed = 20090402;  // arbitrary; fixed, so that reports repeat
constexpr double in_thousandths = 1000;

using Fields = std::vector<FieldSnapshot>;

Fields with_pressure(Fields fields, const std::function<double(double)>& changed) {
  for (FieldSnapshot& field : fields)
    for (double& pressure : field.pressure) pressure = changed(pressure);
  return fields;
}

Fields scaled(Fields fields, double factor) {
  return with_pressure(std::move(fields), [factor](double pressure) { return factor * pressure; });
}

Fields raised(Fields fields, double offset) {
  return with_pressure(std::move(fields), [offset](double pressure) { return pressure + offset; });
}

Fields moved(Fields fields, double distance) {
  for (FieldSnapshot& field : fields)
    for (double& x : field.x) x += distance;
  return fields;
}

Fields noisy(Fields fields, double share) {
  std::mt19937_64 generator(field_noise_seed);
  std::normal_distribution<double> normal;
  for (FieldSnapshot& field : fields) {
    const double deviation = share * rms(without_mean(field.pressure));
    for (double& pressure : field.pressure) pressure += deviation * normal(generator);
  }
  return fields;
}

Fields poisoned(Fields fields) {
  for (FieldSnapshot& field : fields)
    if (!field.pressure.empty()) field.pressure[field.pressure.size() / 2] = not_a_number;
  return fields;
}

}  // namespace

std::size_t moments_left(std::size_t moments, double s) {
  constexpr double rounding = 1e-9;  // a fifth of five moments is one
  const double lost = std::ceil(s * static_cast<double>(moments) - rounding);
  return lost >= static_cast<double>(moments) ? 0 : moments - static_cast<std::size_t>(lost);
}

Fields mutated(Fields fields, const Mutation& mutation, const FieldMutationFrame& frame) {
  const double s = mutation.strength;
  switch (mutation.kind) {
    case MutationKind::louder:
      return scaled(std::move(fields), 1 + s);
    case MutationKind::quieter:
      return scaled(std::move(fields), 1 - s);
    case MutationKind::thousandfold:
      return scaled(std::move(fields), in_thousandths);
    case MutationKind::sign_flipped:
      return scaled(std::move(fields), -1);
    case MutationKind::raised:
      return raised(std::move(fields), s * frame.datum);
    case MutationKind::lowered:
      return raised(std::move(fields), -s * frame.datum);
    case MutationKind::late:
      return moved(std::move(fields), s * frame.length);
    case MutationKind::early:
      return moved(std::move(fields), -s * frame.length);
    case MutationKind::noisy:
      return noisy(std::move(fields), s);
    case MutationKind::truncated:
      fields.resize(moments_left(fields.size(), s));
      return fields;
    case MutationKind::not_a_number:
      return poisoned(std::move(fields));
    default:
      throw std::logic_error("a field has no mutation \"" + mutation_name(mutation.kind) + "\"");
  }
}

}  // namespace slosh
