#include "verification/series/readings/flat_crests.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "verification/series/readings/interruption.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr double bands[] = {1e-3, 3e-3, 0.01, 0.02, 0.04, 0.08};  // of the range
// Of what a round crest falls by inside.
constexpr double most_of_round = 0.2, most_of_round_below = 0.04;
constexpr double standard_errors = 2.5;
constexpr double least_near = 0.4;  // of the drop outside
constexpr std::size_t fewest_fitted = 6, fewest_below = 4, fewest_run = 5,
                      most_overshoot = 2;  // at either edge
constexpr std::size_t most_inside = 12, fewest_sides = 4;
constexpr double against_whole = 2, against_once = 0.9, against_lines = 0.5;
constexpr double most_left = 0.25;  // of what is hidden, of a sample
constexpr double noise_known_to = 1.8;
constexpr double exactly = 1e-9;  // of what is hidden

// By the straight line between the samples.
double value_at(const TimeSeries& series, double time) {
  const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  const double share = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return std::lerp(series.value[i - 1], series.value[i], share);
}

// The samples of a crest that lie within a band of one value.
struct Top {
  FlatExtreme flat;
  double fall, variance;  // of the parabola through them, from its middle to its ends
  double near;            // the share of the drop outside that the nearer half of it has
  Misfits left = {};
  double asked = 0, noise = 0;  // samples, and the sum of squares that noise leaves of them
};

// By least squares; the whole band and no variance of few samples.
void fit_parabola(const TimeSeries& series, std::size_t first, std::size_t last, double band,
                  Top& top) {
  const std::size_t count = last - first + 1;
  top.fall = band;
  top.variance = 0;
  if (count < fewest_fitted) return;
  const double middle = (top.flat.begin + top.flat.end) / 2, half = top.flat.end - middle;
  Eigen::MatrixX3d powers(count, 3);
  Eigen::VectorXd values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = (series.time[first + i] - middle) / half;
    const auto row = static_cast<Eigen::Index>(i);
    powers.row(row) << 1, x, x * x;
    values[row] = series.value[first + i] - top.flat.value;
  }
  const Eigen::Matrix3d inverse = (powers.transpose() * powers).inverse();
  const Eigen::Vector3d found = inverse * (powers.transpose() * values);
  top.fall = std::abs(found[2]);
  top.variance =
      (values - powers * found).squaredNorm() / static_cast<double>(count - 3) * inverse(2, 2);
}

// What all crests are sought with.
struct Search {
  const TimeSeries& series;
  double range, step;
  TimeWindow window;
  double variance;  // of the noise
};

// By the fourth differences, which a smooth series hardly has.
double variance_of_noise(const std::vector<double>& value, double step) {
  if (value.size() < 5) return 0;
  std::vector<double> fourth;
  for (std::size_t i = 4; i < value.size(); ++i)
    fourth.push_back(
        std::abs(value[i] - 4 * value[i - 1] + 6 * value[i - 2] - 4 * value[i - 3] + value[i - 4]));
  const double normal = median(std::move(fourth)) / 0.6745;
  return std::max(normal * normal / 70, step * step / 12);
}

// The means of groups of samples inside of a stretch and beside it; empty where an end of the
// series is near.
struct CrestInGroups {
  std::size_t group, sides;
  std::vector<double> times, values;
};

CrestInGroups crest_in_groups(const TimeSeries& series, std::size_t first, std::size_t last) {
  const std::size_t count = last - first + 1, group = count / most_inside + 1,
                    inside = count / group, sides = std::max(fewest_sides, inside / 2 + 1),
                    beside = sides * group;
  CrestInGroups found{group, sides, {}, {}};
  if (first < beside || last + beside >= series.value.size()) return found;
  for (std::size_t i = first - beside; found.times.size() < 2 * sides + inside; i += group) {
    if (found.times.size() == sides) i = first;
    if (found.times.size() == sides + inside) i = last + 1;
    const auto mean_from = [&](const std::vector<double>& all) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i);
      return mean({begin, begin + static_cast<std::ptrdiff_t>(group)});
    };
    found.times.push_back(mean_from(series.time));
    found.values.push_back(mean_from(series.value));
  }
  return found;
}

void add_misfits(const Search& of, std::size_t first, std::size_t last, Top& top) {
  const auto [group, sides, times, values] = crest_in_groups(of.series, first, last);
  if (times.empty()) return;
  const Interruption crest(times, sides, 0, {6, 4, 0});
  top.left = crest.misfits(values.data());
  top.asked = static_cast<double>(times.size());
  top.noise = noise_known_to * of.variance / static_cast<double>(group) * crest.freedom();
}

// Whose edges lie between the samples from first to last and their neighbours; nullopt where it
// reaches an end of the series or hides too little.
std::optional<Top> top_of(const Search& of, double band, std::size_t first, std::size_t last) {
  const auto& [name, unit, time, value] = of.series;
  if (last + 1 < first + fewest_in_flat || first == 0 || last + 1 == time.size())
    return std::nullopt;
  const double begin = (time[first - 1] + time[first]) / 2, end = (time[last] + time[last + 1]) / 2,
               half = (end - begin) / 2;
  if (begin - half <= time.front() || end + half >= time.back()) return std::nullopt;
  std::vector<double> inside(value.begin() + static_cast<std::ptrdiff_t>(first),
                             value.begin() + static_cast<std::ptrdiff_t>(last + 1));
  const auto lower = inside.begin() + (std::ssize(inside) - 1) / 2;
  std::ranges::nth_element(inside, lower);
  const double middle = *lower;
  const double drop =
      middle - std::max(value_at(of.series, begin - half), value_at(of.series, end + half));
  if (drop / 3 < least_hidden * of.range) return std::nullopt;
  const double near =
      middle - std::max(value_at(of.series, begin - half / 2), value_at(of.series, end + half / 2));
  Top top{{middle, begin, end, drop / 3}, 0, 0, near / drop};
  fit_parabola(of.series, first, last, band, top);
  add_misfits(of, first, last, top);
  top.fall = std::max(top.fall, of.step);
  return top;
}

// Crests that are judged together.
class Sum {
 public:
  explicit Sum(TimeWindow window) : window_(window) {}

  void add(const Top& top) {
    hidden_ += top.flat.hidden;
    fall_ += top.fall;
    variance_ += top.variance;
    left_.add(top.left);
    asked_ += top.asked;
    noise_ += top.noise;
    ++count_;
    const bool meets = top.flat.begin < window_.end && top.flat.end > window_.begin;
    if (meets && !(worst_ && worst_->hidden >= top.flat.hidden)) worst_ = top.flat;
  }
  std::size_t count() const { return count_; }
  // The one that meets the window and hides most, where all are flat together.
  std::optional<FlatExtreme> flat(double most) const {
    const bool is_flat = fall_ + standard_errors * std::sqrt(variance_) <= most * hidden_;
    return is_flat && is_interrupted() ? worst_ : std::nullopt;
  }

 private:
  // Whether a curve that is cut off describes the crests better than one that is flat does.
  bool is_interrupted() const {
    if (asked_ == 0) return true;
    const double hidden = hidden_ / static_cast<double>(count_),
                 floor = asked_ * hidden * hidden * exactly * exactly,
                 own = left_.interrupted + floor, noise = count_ >= fewest_below ? noise_ : 0;
    return own <= asked_ * std::pow(most_left * hidden, 2) && left_.whole + floor >= own &&
           left_.whole + floor - noise >= against_whole * (own - noise) &&
           left_.once + floor >= against_once * own && left_.lines + floor >= against_lines * own;
  }

  TimeWindow window_;
  Misfits left_;
  double asked_ = 0, noise_ = 0;
  double hidden_ = 0, fall_ = 0, variance_ = 0;
  std::size_t count_ = 0;
  std::optional<FlatExtreme> worst_;
};

std::optional<FlatExtreme> flat_at_highest(const Search& of, double highest, double band) {
  const std::vector<double>& value = of.series.value;
  Sum sum(of.window);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::size_t first = i;
    while (i < value.size() && highest - value[i] <= band) ++i;
    if (i == first) continue;
    if (const auto top = top_of(of, band, first, i - 1)) sum.add(*top);
  }
  return sum.flat(most_of_round);
}

// The samples from first to before `end`, where a series stays above its mean, the highest and the
// highest that is no overshoot.
struct Crest {
  std::size_t first, end;
  double highest, settled;
};

std::vector<Crest> crests_of(const TimeSeries& series) {
  const std::vector<double>& value = series.value;
  const double middle = mean(value);
  std::vector<Crest> crests;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::size_t first = i;
    while (i < value.size() && value[i] > middle) ++i;
    if (i - first < fewest_in_flat) continue;
    std::vector<double> inside(value.begin() + static_cast<std::ptrdiff_t>(first),
                               value.begin() + static_cast<std::ptrdiff_t>(i));
    const std::size_t above = std::min(2 * most_overshoot, inside.size() - 1);
    const auto settled = inside.begin() + static_cast<std::ptrdiff_t>(above);
    std::nth_element(inside.begin(), settled, inside.end(), std::greater());
    crests.push_back({first, i, *std::max_element(inside.begin(), settled + 1), *settled});
  }
  return crests;
}

// The longest run of samples within a band of a level, which holds all of them but one, and beside
// which no more than an overshoot is higher.
std::optional<Top> top_at(const Search& of, const Crest& crest, double level, double band) {
  const std::vector<double>& value = of.series.value;
  std::size_t first = crest.first, end = crest.first, all = 0;
  for (std::size_t i = crest.first; i < crest.end; ++i) {
    const std::size_t begin = i;
    while (i < crest.end && std::abs(value[i] - level) <= band) ++i;
    if (i - begin > end - first) first = begin, end = i;
    all += i - begin;
  }
  if (end - first < fewest_run || all > end - first + 1) return std::nullopt;
  bool is_exceeded = false;
  for (std::size_t i = crest.first; i < crest.end; ++i) {
    if (value[i] <= level + band) continue;
    if (i + most_overshoot < first || i >= end + most_overshoot) return std::nullopt;
    is_exceeded = true;
  }
  auto top = top_of(of, band, first, end - 1);
  if (top && !is_exceeded && top->near < least_near) return std::nullopt;
  return top;
}

std::optional<FlatExtreme> flat_below(const Search& of, const std::vector<Crest>& crests,
                                      double highest, double band) {
  std::vector<Top> tops;
  for (const Crest& crest : crests) {
    if (const auto top = top_at(of, crest, crest.highest, band)) tops.push_back(*top);
    if (crest.highest - crest.settled <= band) continue;
    if (const auto top = top_at(of, crest, crest.settled, band)) tops.push_back(*top);
  }
  const auto by_value = [](const Top& one) { return one.flat.value; };
  std::ranges::sort(tops, {}, by_value);
  // Bands that overlap by half: no crest is asked more than four times.
  for (auto at = tops.begin(); at != tops.end();) {
    const double level = at->flat.value;
    Sum sum(of.window);
    for (auto one = std::ranges::lower_bound(tops, level - band, {}, by_value);
         one != tops.end() && one->flat.value <= level + band; ++one)
      sum.add(*one);
    if (sum.count() >= fewest_below && highest - level >= least_hidden * of.range)
      if (auto flat = sum.flat(most_of_round_below)) return flat;
    at = std::ranges::upper_bound(at, tops.end(), level + band / 2, {}, by_value);
  }
  return std::nullopt;
}

}  // namespace

std::optional<FlatExtreme> flat_crest(const TimeSeries& series, double step, TimeWindow window) {
  const auto [low, high] = std::ranges::minmax(series.value);
  const Search of{series, high - low, step, window, variance_of_noise(series.value, step)};
  const std::vector<Crest> crests = crests_of(series);
  for (const double share : bands) {
    const double band = share * of.range;
    if (auto flat = flat_at_highest(of, high, band)) return flat;
    if (auto flat = flat_below(of, crests, high, band)) return flat;
  }
  return std::nullopt;
}

}  // namespace slosh
