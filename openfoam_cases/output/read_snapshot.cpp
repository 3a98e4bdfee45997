#include "openfoam_cases/output/read_snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/output/read_series.hpp"
#include "openfoam_cases/output/uniform_cells.hpp"
#include "openfoam_cases/time_step.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

struct TimeDirectory {
  double time = std::numeric_limits<double>::infinity();
  fs::path path;
};

TimeDirectory nearest_directory(const fs::path& case_directory, double time) {
  TimeDirectory nearest;
  for (const auto& entry : fs::directory_iterator(case_directory)) {
    const std::vector<double> numbers = numbers_in(entry.path().filename().string());
    if (!entry.is_directory() || numbers.size() != 1 || !(numbers[0] > 0)) continue;
    if (std::abs(numbers[0] - time) < std::abs(nearest.time - time)) {
      nearest = {numbers[0], entry.path()};
    }
  }
  return nearest;
}

// Returns the internal field, one row per cell; a uniform field has one row in the file.
std::vector<std::vector<double>> read_field(const fs::path& file, std::size_t cells,
                                            std::size_t components) {
  std::ifstream in(file);
  if (!in) refuse(file, "missing: its function object has not run");
  std::string line;
  while (std::getline(in, line) && !line.starts_with("internalField")) {
  }
  std::vector<std::vector<double>> rows;
  if (const auto uniform = line.find(" uniform "); uniform != line.npos) {
    rows.assign(cells, numbers_in(line.substr(uniform + 9, line.find(';') - uniform - 9)));
  } else {
    while (std::getline(in, line) && line != "(") {
    }
    while (std::getline(in, line) && line != ")") rows.push_back(numbers_in(line));
  }
  const auto is_sound = [components](const std::vector<double>& row) {
    return row.size() == components &&
           std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
  };
  const auto bad = std::find_if_not(rows.begin(), rows.end(), is_sound);
  if (rows.size() != cells || bad != rows.end()) {
    refuse(file, fmt::format("{} cells, of which cell {} is the first without {} finite numbers, "
                             "expected {} cells with them",
                             rows.size(), bad - rows.begin(), components, cells));
  }
  return rows;
}

std::vector<double> component(const std::vector<std::vector<double>>& rows, std::size_t index) {
  std::vector<double> values;
  for (const std::vector<double>& row : rows) values.push_back(row[index]);
  return values;
}

// Returns the size of each cell in all layers, in whole cells.
std::vector<double> sizes_in_all_layers(const TankMesh& mesh) {
  std::vector<double> sizes;
  const std::vector<Cell> cells = mesh.cells_of_all_layers();
  const Layers& layers = mesh.layers();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int layer =
        layers.is_half_gap() ? static_cast<int>(i) / mesh.columns() % layers.count() : 0;
    sizes.push_back(mesh.whole_cells(cells[i]) * layers.share(layer));
  }
  return sizes;
}

// Returns what a field has in the layer in the middle of the gap.
std::vector<double> in_measured_layer(const TankMesh& mesh, std::vector<double> field) {
  if (!mesh.layers().is_half_gap()) return field;
  std::vector<double> middle;
  const int row = mesh.columns();
  const int last = mesh.layers().count() - 1, of_rows = row * mesh.layers().count();
  for (auto at = field.begin(); at != field.end(); at += of_rows)
    middle.insert(middle.end(), at + last * row, at + of_rows);
  return middle;
}

// Subtracts the mean over the gas.
void set_gas_datum(const std::vector<double>& sizes, const std::vector<double>& liquid_share,
                   std::vector<double>& pressure) {
  double gas = 0, sum = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    gas += sizes[i] * (1 - liquid_share[i]);
    sum += sizes[i] * (1 - liquid_share[i]) * pressure[i];
  }
  for (double& value : pressure) value -= sum / gas;
}

void take_uniform_cells(const TankMesh& mesh, FieldSnapshot& snapshot) {
  for (std::vector<double>* field :
       {&snapshot.velocity_x, &snapshot.velocity_z, &snapshot.pressure, &snapshot.liquid_share})
    *field = means_over_uniform_cells(mesh, *field);
  const CellFaces across(mesh.length(), mesh.columns()), up(mesh.up().length(), mesh.rows());
  for (int row = 0; row < mesh.rows(); ++row)
    for (int column = 0; column < mesh.columns(); ++column) {
      const int cell = row * mesh.columns() + column;
      snapshot.x[cell] = across.centre(column);
      snapshot.z[cell] = up.centre(row);
      snapshot.area[cell] = mesh.cell_width() * mesh.cell_height();
    }
}

}  // namespace

FieldSnapshot read_snapshot(const SloshingTank& tank, const TankMesh& mesh,
                            const fs::path& case_directory, double time) {
  const TimeDirectory directory = nearest_directory(case_directory, time);
  if (!(std::abs(directory.time - time) <= max_time_step(tank))) {
    refuse(case_directory,
           fmt::format("no fields at {} s, the nearest are at {} s", time, directory.time));
  }
  FieldSnapshot snapshot;
  snapshot.time = directory.time;
  snapshot.cell_width = mesh.cell_width();
  snapshot.cell_height = mesh.cell_height();
  for (const Cell cell : mesh.cells()) {
    const Corner centre = mesh.centre(cell);
    snapshot.x.push_back(centre.x);
    snapshot.z.push_back(centre.z);
    snapshot.area.push_back(mesh.whole_cells(cell) * mesh.cell_width() * mesh.cell_height());
  }
  const std::size_t cells = mesh.cells_in_all_layers();
  const auto velocity = read_field(directory.path / "U", cells, 3);
  snapshot.velocity_x = component(velocity, 0);
  snapshot.velocity_z = component(velocity, 2);
  snapshot.liquid_share = component(read_field(directory.path / "alpha.liquid", cells, 1), 0);
  snapshot.pressure = component(read_field(directory.path / "p", cells, 1), 0);
  set_gas_datum(sizes_in_all_layers(mesh), snapshot.liquid_share, snapshot.pressure);
  for (std::vector<double>* field :
       {&snapshot.velocity_x, &snapshot.velocity_z, &snapshot.pressure, &snapshot.liquid_share})
    *field = in_measured_layer(mesh, std::move(*field));
  if (mesh.is_graded()) take_uniform_cells(mesh, snapshot);
  return snapshot;
}

}  // namespace slosh::openfoam
