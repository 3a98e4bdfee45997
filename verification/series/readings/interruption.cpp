#include "verification/series/readings/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace slosh {
namespace {

constexpr std::size_t degree_of_short = 2;  // before or after a single break
constexpr double most_out_of_range = 0.5;   // of the range outside

enum Asked { before = 1, inside = 2, after = 4 };

std::vector<std::size_t> chosen(std::size_t size, std::size_t sides, std::size_t guard, int asked) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t from_end = size - 1 - i, edge = sides + guard;
    if ((i < sides && (asked & before)) || (from_end < sides && (asked & after)) ||
        (i >= edge && from_end >= edge && (asked & inside)))
      found.push_back(i);
  }
  return found;
}

}  // namespace

void Misfits::add(const Misfits& other) {
  whole += other.whole;
  interrupted += other.interrupted;
  once += other.once;
  lines += other.lines;
}

Polynomials::Polynomials(const std::vector<double>& places, std::vector<std::size_t> chosen,
                         std::size_t degree)
    : chosen_(std::move(chosen)) {
  const double middle = (places.front() + places.back()) / 2, half = places.back() - middle;
  const auto product = [&](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (const std::size_t i : chosen_) sum += a[i] * b[i];
    return sum;
  };
  while (at_.size() < std::min(degree + 1, chosen_.size())) {
    std::vector<double> next(places.size(), 1);
    for (std::size_t i = 0; i < next.size() && !at_.empty(); ++i)
      next[i] = at_.back()[i] * (places[i] - middle) / half;
    for (int twice = 0; twice < 2; ++twice)
      for (const std::vector<double>& one : at_) {
        const double share = product(next, one);
        for (std::size_t i = 0; i < next.size(); ++i) next[i] -= share * one[i];
      }
    const double length = std::sqrt(product(next, next));
    for (double& value : next) value /= length;
    at_.push_back(std::move(next));
  }
}

double Polynomials::misfit(const double* values) const {
  std::vector<double> left;
  left.reserve(chosen_.size());
  for (const std::size_t i : chosen_) left.push_back(values[i]);
  for (const std::vector<double>& one : at_) {
    double share = 0;
    for (std::size_t k = 0; k < left.size(); ++k) share += left[k] * one[chosen_[k]];
    for (std::size_t k = 0; k < left.size(); ++k) left[k] -= share * one[chosen_[k]];
  }
  return std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
}

std::vector<double> Polynomials::mean_over(const std::vector<std::size_t>& others) const {
  std::vector<double> weights(at_.front().size());
  for (const std::vector<double>& one : at_) {
    double mean = 0;
    for (const std::size_t i : others) mean += one[i] / static_cast<double>(others.size());
    for (const std::size_t i : chosen_) weights[i] += mean * one[i];
  }
  return weights;
}

Interruption::Interruption(const std::vector<double>& places, std::size_t sides, std::size_t guard,
                           Degrees degrees)
    : sides_(sides), departure_(places.size()) {
  const auto of = [&](int asked) { return chosen(places.size(), sides, guard, asked); };
  whole_ = {places, of(before | inside | after), degrees.whole};
  outside_ = {places, of(before | after), degrees.outside};
  inside_ = {places, of(inside), degrees.inside};
  before_ = {places, of(before), degree_of_short};
  from_begin_ = {places, of(inside | after), degrees.outside};
  until_end_ = {places, of(before | inside), degrees.outside};
  after_ = {places, of(after), degree_of_short};
  line_before_ = {places, of(before), 1};
  line_after_ = {places, of(after), 1};
  const std::vector<std::size_t> stretch = of(inside);
  predicted_ = outside_.mean_over(stretch);
  for (std::size_t i = 0; i < places.size(); ++i) departure_[i] = -predicted_[i];
  for (const std::size_t i : stretch) departure_[i] += 1 / static_cast<double>(stretch.size());
  freedom_ = static_cast<double>(places.size() - 2 * guard) -
             static_cast<double>(degrees.outside + degrees.inside + 2);
}

double Interruption::departure(const double* values) const {
  return std::inner_product(departure_.begin(), departure_.end(), values, 0.0);
}

bool Interruption::overshoots(const double* values) const {
  const double* after = values + (size() - sides_);
  const auto [low_before, high_before] = std::minmax_element(values, values + sides_);
  const auto [low_after, high_after] = std::minmax_element(after, after + sides_);
  const double low = std::min(*low_before, *low_after), high = std::max(*high_before, *high_after);
  const double value = std::inner_product(predicted_.begin(), predicted_.end(), values, 0.0);
  return std::max(low - value, value - high) > most_out_of_range * (high - low);
}

double Interruption::interrupted(const double* values) const {
  return outside_.misfit(values) + inside_.misfit(values);
}

double Interruption::once(const double* values) const {
  return std::min(before_.misfit(values) + from_begin_.misfit(values),
                  until_end_.misfit(values) + after_.misfit(values));
}

double Interruption::lines(const double* values) const {
  return line_before_.misfit(values) + inside_.misfit(values) + line_after_.misfit(values);
}

Misfits Interruption::misfits(const double* values) const {
  return {whole(values), interrupted(values), once(values), lines(values)};
}

}  // namespace slosh
