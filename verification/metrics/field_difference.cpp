#include "verification/metrics/field_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double covered_from = 0.5;    // of a cell's box: that of a volume fraction
constexpr double on_mesh = 0.01;        // of a cell: middles are printed with some digits
constexpr double largest_place = 100;   // cells; larger ones are a wrong unit
constexpr double farthest_place = 1e6;  // cells; farther ones have left every tank
constexpr double touching = 1e-9;       // of a cell: less in common is round-off

using CellIndex = std::pair<long, long>;  // column and row, from the reference's first cell

// One direction of the mesh: the cell i has its middle at origin + i size.
struct Axis {
  double origin, size;

  double index_of(double middle) const { return (middle - origin) / size; }
};

struct Mesh {
  Axis x, z;
};

// What the candidate's places leave in a cell.
struct Deposit {
  double area = 0;           // over the box's
  double area_pressure = 0;  // [Pa]

  double pressure() const { return area_pressure / area; }
};

void require_field(const char* role, const FieldSnapshot& field) {
  const std::size_t places = field.x.size();
  const auto refuse = [&](const std::string& why) {
    throw ComparisonError(fmt::format("the {}'s field at {:.4g} s {}", role, field.time, why));
  };
  if (places == 0) refuse("has no liquid");
  if (field.z.size() != places || field.pressure.size() != places) refuse("is incomplete");
  for (const double size : {field.width, field.height})
    if (!(std::isfinite(size) && size > 0)) refuse("has places without a size");
  for (const std::vector<double>* values : {&field.x, &field.z, &field.pressure})
    for (const double value : *values)
      if (!std::isfinite(value)) refuse("has a number that is not finite");
}

// Throws ComparisonError where the middle is not that of a cell.
long cell_at(const Axis& axis, double middle) {
  const double index = axis.index_of(middle);
  if (!(std::abs(index) < farthest_place && std::abs(index - std::round(index)) < on_mesh))
    throw ComparisonError(fmt::format(
        "the reference's field has a place at {:.6g} m that is on no mesh of {:.4g} m; expected "
        "the cells of interFoam",
        middle, axis.size));
  return std::lround(index);
}

std::map<CellIndex, double> pressure_by_cell(const FieldSnapshot& reference, const Mesh& mesh) {
  std::map<CellIndex, double> pressure;
  for (std::size_t i = 0; i < reference.x.size(); ++i)
    pressure[{cell_at(mesh.x, reference.x[i]), cell_at(mesh.z, reference.z[i])}] =
        reference.pressure[i];
  if (pressure.size() != reference.x.size())
    throw ComparisonError("the reference's field has a cell twice");
  return pressure;
}

// The cells whose boxes a place touches, and the share of the box that they have in common.
std::vector<std::pair<long, double>> shares_along(const Axis& axis, double middle, double width) {
  const double box = std::max(axis.size, width), reach = (box + width) / 2;
  if (width > largest_place * axis.size || std::abs(axis.index_of(middle)) > farthest_place)
    throw ComparisonError(fmt::format(
        "the candidate's field has a place at {:.4g} m, {:.4g} m wide, that is no part of a tank "
        "with cells of {:.4g} m",
        middle, width, axis.size));
  std::vector<std::pair<long, double>> shares;
  const long last = std::lround(std::floor(axis.index_of(middle + reach)));
  for (long i = std::lround(std::ceil(axis.index_of(middle - reach))); i <= last; ++i) {
    const double centre = axis.origin + static_cast<double>(i) * axis.size;
    const double common = std::min(middle + width / 2, centre + box / 2) -
                          std::max(middle - width / 2, centre - box / 2);
    if (common > touching * axis.size) shares.push_back({i, common / box});
  }
  return shares;
}

std::map<CellIndex, Deposit> on_the_mesh(const FieldSnapshot& candidate, const Mesh& mesh) {
  std::map<CellIndex, Deposit> deposits;
  for (std::size_t a = 0; a < candidate.x.size(); ++a) {
    const auto rows = shares_along(mesh.z, candidate.z[a], candidate.height);
    for (const auto& [column, along_x] : shares_along(mesh.x, candidate.x[a], candidate.width))
      for (const auto& [row, along_z] : rows) {
        Deposit& deposit = deposits[{column, row}];
        deposit.area += along_x * along_z;
        deposit.area_pressure += along_x * along_z * candidate.pressure[a];
      }
  }
  std::erase_if(deposits, [](const auto& one) { return !(one.second.area >= covered_from); });
  return deposits;
}

struct ComparedCell {
  double candidate, reference;  // [Pa]
};

std::vector<ComparedCell> compared_cells(const std::map<CellIndex, Deposit>& covered,
                                         const std::map<CellIndex, double>& liquid) {
  std::vector<ComparedCell> cells;
  for (const auto& [cell, pressure] : liquid)
    if (const auto found = covered.find(cell); found != covered.end())
      cells.push_back({found->second.pressure(), pressure});
  return cells;
}

template <class Value>
double mean(const std::vector<ComparedCell>& cells, const Value& value) {
  double sum = 0;
  for (const ComparedCell& cell : cells) sum += value(cell);
  return sum / static_cast<double>(cells.size());
}

double lowest(const std::vector<ComparedCell>& cells, double ComparedCell::*pressure) {
  double found = cells.front().*pressure;
  for (const ComparedCell& cell : cells) found = std::min(found, cell.*pressure);
  return found;
}

}  // namespace

FieldDifference field_difference(const FieldSnapshot& candidate, const FieldSnapshot& reference,
                                 double small_tension) {
  require_field("candidate", candidate);
  require_field("reference", reference);
  const Mesh mesh{{reference.x.front(), reference.width}, {reference.z.front(), reference.height}};
  const std::map<CellIndex, double> liquid = pressure_by_cell(reference, mesh);
  const std::map<CellIndex, Deposit> covered = on_the_mesh(candidate, mesh);
  const std::vector<ComparedCell> cells = compared_cells(covered, liquid);
  const double count = static_cast<double>(liquid.size());
  const double covered_share = static_cast<double>(cells.size()) / count;
  if (!(covered_share >= least_covered_share))
    throw ComparisonError(fmt::format(
        "the candidate's liquid covers {:.3g} % of the reference's at {:.4g} s; expected {:.3g} % "
        "or more",
        100 * covered_share, reference.time, 100 * least_covered_share));
  const auto difference = [](const ComparedCell& cell) { return cell.candidate - cell.reference; };
  const auto square = [](double value) { return value * value; };
  return {
      .time = reference.time,
      .compared_cells = cells.size(),
      .pressure_rms = std::sqrt(
          mean(cells, [&](const ComparedCell& cell) { return square(difference(cell)); })),
      .pressure_offset = mean(cells, difference),
      .candidate_rms =
          std::sqrt(mean(cells, [&](const ComparedCell& cell) { return square(cell.candidate); })),
      .lowest_pressure = lowest(cells, &ComparedCell::candidate),
      .reference_lowest_pressure = lowest(cells, &ComparedCell::reference),
      .tension_share =
          mean(cells, [&](const ComparedCell& cell) { return cell.candidate < -small_tension; }),
      .reference_tension_share =
          mean(cells, [&](const ComparedCell& cell) { return cell.reference < -small_tension; }),
      .uncovered_share = 1 - covered_share,
      .excess_share = static_cast<double>(covered.size() - cells.size()) / count};
}

}  // namespace slosh
