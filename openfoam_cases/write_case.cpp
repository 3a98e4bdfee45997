// Fills the templates of a case directory from the tank's description. Everything that the
// dictionaries need is computed here once, and written in the shortest form that reads back as
// the same double.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <kainjow/mustache.hpp>
#include <numbers>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/geometry/block_mesh.hpp"
#include "openfoam_cases/geometry/front_position.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/surging_tank.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;

std::string number(double value) { return fmt::format("{}", value); }

// Euler's and the source's first-order error in time damps and shifts the first natural mode by
// about omega_1 dt. At a hundredth (2 ms in the 1 m tank filled to 0.35 m) that mode's frequency is
// right to 0.02 % at 50 x 50 cells; half the step changes its decay from 0.0067 to 0.0053 1/s.
double max_time_step(const SurgingTank& tank) {
  const double wave_number = std::numbers::pi / tank.length;
  const double omega_1 =
      std::sqrt(tank.gravity * wave_number * std::tanh(wave_number * tank.fill_depth));
  return 0.01 / omega_1;
}

// The liquid's share of each cell, in OpenFOAM's order.
std::string liquid_fractions(const SurgingTank& tank, const TankMesh& mesh) {
  std::vector<double> fractions;
  for (const Cell cell : mesh.cells()) fractions.push_back(liquid_share(tank, cell));
  return fmt::format("{}", fmt::join(fractions, "\n"));
}

// The solver ends with an error where the table does, so it goes on past the end; 2000 intervals
// keep the spline's error below the time step's where samples are far apart.
data acceleration_table(const SurgingTank& tank) {
  const double step = std::min(tank.sample_interval, tank.duration / 2000);
  const int count = static_cast<int>(std::ceil(tank.duration / step)) + 10;
  data table(data::type::list);
  for (int i = 0; i < count; ++i) {
    const double value = tank.acceleration(i * step);
    require(std::isfinite(value), "acceleration", value, fmt::format("finite at {} s", i * step));
    data row;
    row.set("time", number(i * step));
    row.set("value", number(value));
    table << row;
  }
  return table;
}

// Boxes around the columns' cell centres; their faces stay off every centre.
data column_boxes(const SurgingTank& tank, const TankMesh& mesh) {
  const double width = tank.length / tank.cells_x;
  data columns(data::type::list);
  for (const int index : columns_read(tank, mesh)) {
    data column;
    column.set("name", column_name(index));
    column.set("x_min", number((index + 0.25) * width));
    column.set("x_max", number((index + 0.75) * width));
    columns << column;
  }
  return columns;
}

data blocks(const std::vector<BlockMesh::Hexahedron>& hexahedra) {
  data list(data::type::list);
  for (const BlockMesh::Hexahedron& hexahedron : hexahedra) {
    data block;
    block.set("corners", hexahedron.corners);
    block.set("block_cells_x", number(hexahedron.cells_x));
    block.set("block_cells_z", number(hexahedron.cells_z));
    list << block;
  }
  return list;
}

// The centres of the lowest row of cells; false, which leaves its section out, without a front.
data bottom_row(const SurgingTank& tank, const TankMesh& mesh) {
  if (!tank.column_width) return data(false);
  data places(data::type::list);
  for (const int column : bottom_columns(mesh)) {
    data place;
    place.set("x", number((column + 0.5) * mesh.cell_width()));
    place.set("z", number(0.5 * mesh.cell_height()));
    places << place;
  }
  data row;
  row.set("places", places);
  return row;
}

data template_values(const SurgingTank& tank) {
  const TankMesh mesh(tank);
  const BlockMesh block_mesh = openfoam::block_mesh(mesh);
  const Cell reference = mesh.reference_cell();
  data values;
  const auto set = [&values](const char* name, double value) { values.set(name, number(value)); };
  set("height", tank.height);
  values.set("vertices", block_mesh.vertices);
  values.set("blocks", blocks(block_mesh.hexahedra));
  values.set("wall_faces", block_mesh.wall_faces);
  values.set("front_and_back_faces", block_mesh.front_and_back_faces);
  set("cell_count", mesh.free_cells());
  set("gravity", tank.gravity);
  set("liquid_density", tank.liquid.density);
  set("liquid_kinematic_viscosity", tank.liquid.kinematic_viscosity);
  set("gas_density", tank.gas.density);
  set("gas_kinematic_viscosity", tank.gas.kinematic_viscosity);
  set("initial_relative_velocity", tank.initial_relative_velocity);
  set("duration", tank.duration);
  set("sample_interval", tank.sample_interval);
  set("max_time_step", max_time_step(tank));
  set("processes", tank.processes);
  set("reference_x", (reference.column + 0.5) * tank.length / tank.cells_x);
  set("reference_z", (reference.row + 0.5) * tank.height / tank.cells_z);
  values.set("liquid_fractions", liquid_fractions(tank, mesh));
  const data table = acceleration_table(tank);
  set("acceleration_count", table.list_value().size());
  values.set("acceleration", table);
  values.set("columns", column_boxes(tank, mesh));
  values.set("bottom_row", bottom_row(tank, mesh));
  return values;
}

// A name that a template uses and nothing defines is an error, not an empty string.
class StrictContext : public kainjow::mustache::context<std::string> {
 public:
  explicit StrictContext(const data* values) : context(values) {}
  const data* get(const std::string& name) const override {
    const data* value = context::get(name);
    if (value == nullptr) throw std::invalid_argument("nothing defines {{" + name + "}}");
    return value;
  }
};

void fill_template(const fs::path& source, const fs::path& target, const data& values) {
  std::ifstream in(source);
  kainjow::mustache::mustache text(std::string(std::istreambuf_iterator<char>(in), {}));
  if (!in || !text.is_valid()) {
    throw RunError(fmt::format("template {}: {}", source.string(), text.error_message()));
  }
  text.set_custom_escape([](const std::string& plain) { return plain; });
  StrictContext context(&values);
  std::ofstream out(target);
  try {
    out << text.render(context);
  } catch (const std::invalid_argument& error) {
    throw RunError(fmt::format("template {}: {}", source.string(), error.what()));
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + target.string());
}

}  // namespace

void write_case(const SurgingTank& tank, const fs::path& template_directory,
                const fs::path& case_directory) {
  check_tank(tank);
  // An earlier run's series would be taken for this one's.
  if (fs::exists(case_directory) && !fs::is_empty(case_directory)) {
    throw std::invalid_argument("case directory " + case_directory.string() + " is not empty");
  }
  const data values = template_values(tank);
  fs::create_directories(case_directory);
  for (const auto& entry : fs::recursive_directory_iterator(template_directory)) {
    const fs::path target = case_directory / fs::relative(entry.path(), template_directory);
    if (entry.is_directory()) {
      fs::create_directories(target);
    } else {
      fill_template(entry.path(), target, values);
    }
  }
}

}  // namespace slosh::openfoam
