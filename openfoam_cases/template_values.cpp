#include "openfoam_cases/template_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/compressible_fluids.hpp"
#include "openfoam_cases/frame_motion.hpp"
#include "openfoam_cases/geometry/block_mesh.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/geometry/liquid_edge.hpp"
#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/outline/facing.hpp"
#include "openfoam_cases/time_step.hpp"

namespace slosh::openfoam {
namespace {

using kainjow::mustache::data;

std::string number(double value) { return fmt::format("{}", value); }

// Returns the liquid's volume fraction in each cell, in OpenFOAM's order.
std::string liquid_fractions(const SloshingTank& tank, const TankMesh& mesh) {
  std::vector<double> fractions;
  for (const Cell cell : mesh.cells_of_all_layers())
    fractions.push_back(liquid_share(tank, mesh, cell));
  return fmt::format("{}", fmt::join(fractions, "\n"));
}

// The table extends past the end, as the solver stops with an error where the table ends.
data motion_table(const SloshingTank& tank) {
  const double step = motion_step(tank);
  const int count = static_cast<int>(std::ceil(tank.duration / step)) + 10;
  data table(data::type::list);
  for (int i = 0; i < count; ++i) {
    const FrameMotion motion = frame_motion(tank, i * step);
    data row;
    row.set("time", number(i * step));
    row.set("acceleration_x", number(motion.acceleration_x));
    row.set("acceleration_z", number(motion.acceleration_z));
    row.set("omega_y", number(motion.omega_y));
    row.set("omega_y_derivative", number(motion.omega_y_derivative));
    table << row;
  }
  return table;
}

// Returns the initial velocity field, which is uniform without roll.
std::string initial_field(const SloshingTank& tank, const TankMesh& mesh) {
  const auto vector = [&](Cell cell) {
    const Velocity velocity = initial_velocity(tank, mesh, cell);
    return fmt::format("({} 0 {})", velocity.x, velocity.z);
  };
  if (!tank.roll) return "uniform " + vector({0, 0});
  std::vector<std::string> vectors;
  for (const Cell cell : mesh.cells_of_all_layers()) vectors.push_back(vector(cell));
  return fmt::format("nonuniform List<vector> {}\n(\n{}\n)", vectors.size(),
                     fmt::join(vectors, "\n"));
}

// Returns a place in the mesh's coordinates.
data place(const TankMesh& mesh, double x, double z) {
  data place;
  place.set("x", number(x - mesh.origin_x()));
  place.set("z", number(z - mesh.origin_z()));
  return place;
}

data place(const TankMesh& mesh, Corner at) { return place(mesh, at.x, at.z); }

// Returns a section with the list of places; false, which omits the section, for an empty list.
data section(const data& places) {
  if (places.list_value().empty()) return data(false);
  data section;
  section.set("places", places);
  return section;
}

// Returns the numbers of a column's cut cells.
data cell_numbers(const TankMesh& mesh, int column) {
  data section;
  section.set("labels", fmt::format("{}", fmt::join(mesh.cut()->column(column), " ")));
  return section;
}

// Returns the middle half of a column, across [m].
std::pair<double, double> middle_half(const SloshingTank& tank, const TankMesh& mesh, int column) {
  if (mesh.is_graded()) {
    const double left = mesh.face_x(column), width = mesh.across().size(column);
    return {left + 0.25 * width, left + 0.75 * width};
  }
  const double width = tank.length / tank.cells_x;
  return {(column + 0.25) * width, (column + 0.75) * width};
}

// Returns boxes around the centres of the columns' cells; no box has a centre on its face. Cut
// cells, whose centres are elsewhere, are given by their numbers.
data column_boxes(const SloshingTank& tank, const TankMesh& mesh) {
  data columns(data::type::list);
  for (const int index : columns_read(tank, mesh)) {
    data column;
    column.set("name", column_name(index));
    const auto [x_min, x_max] = middle_half(tank, mesh, index);
    column.set("x_min", number(x_min - mesh.origin_x()));
    column.set("x_max", number(x_max - mesh.origin_x()));
    column.set("uniform_cells", data(!mesh.cut()));
    column.set("cut_cells", mesh.cut() ? cell_numbers(mesh, index) : data(false));
    columns << column;
  }
  return columns;
}

// Returns a section with the Darcy coefficient d [1/m2] of a porous medium that slows the liquid
// down at the rate nu d; false, which omits the section, without friction.
data porous_medium(const SloshingTank& tank) {
  if (tank.gap_friction == 0) return data(false);
  data section;
  section.set("darcy_coefficient", number(tank.gap_friction / tank.liquid.kinematic_viscosity));
  return section;
}

data blocks(const std::vector<BlockMesh::Hexahedron>& hexahedra) {
  data list(data::type::list);
  for (const BlockMesh::Hexahedron& hexahedron : hexahedra) {
    data block;
    block.set("corners", hexahedron.corners);
    block.set("block_cells_x", number(hexahedron.cells_x));
    block.set("block_cells_z", number(hexahedron.cells_z));
    block.set("grading_x", hexahedron.grading_x);
    block.set("grading_z", hexahedron.grading_z);
    list << block;
  }
  return list;
}

// Returns the centres of the lowest row of cells, along which a front runs.
data bottom_row(const SloshingTank& tank, const TankMesh& mesh) {
  data places(data::type::list);
  if (tank.column_width) {
    for (const int column : bottom_columns(mesh)) {
      places << place(mesh, mesh.centre_x(column), mesh.centre_z(0));
    }
  }
  return section(places);
}

// Returns the centres of the cells in which the gauges look for the highest surface.
data gauge_cells(const SloshingTank& tank, const TankMesh& mesh) {
  data places(data::type::list);
  for (const int column : probed_columns(tank, mesh)) {
    for (const int row : free_rows(mesh, column)) places << place(mesh, mesh.inside({column, row}));
  }
  return section(places);
}

// Returns the centres of the faces that the pressure gauges read, gauge by gauge.
data wall_pressure(const SloshingTank& tank, const TankMesh& mesh) {
  data places(data::type::list);
  for (const PressureGauge& gauge : tank.pressure_gauges) {
    for (const FaceShare& face : face_shares(mesh, gauge)) places << place(mesh, face.x, face.z);
  }
  return section(places);
}

// Returns the centres of the cells that the probes read, probe by probe.
data probe_cells(const SloshingTank& tank, const TankMesh& mesh) {
  data places(data::type::list);
  for (const Probe& probe : tank.probes) {
    for (const CellShare& share : cell_shares(mesh, probe.x, probe.z)) {
      places << place(mesh, mesh.inside(share.cell));
    }
  }
  return section(places);
}

// Returns the patches of the walls: one, or one for each wall and one for the obstacles where
// forces are recorded by wall.
data wall_patches(const SloshingTank& tank, const BlockMesh& mesh) {
  const bool by_wall = !tank.loaded_walls.empty();
  const auto patch = [&](const std::string& name, const std::string& faces) {
    data values;
    values.set("patch", name);
    values.set("faces", faces);
    values.set("in_group", data(by_wall));
    return values;
  };
  data patches(data::type::list);
  if (mesh.hexahedra.empty()) return patches;  // an outline's mesh is no block mesh
  if (!by_wall) {
    patches << patch("walls", mesh.wall_faces);
    return patches;
  }
  for (const auto& [owner, faces] : mesh.faces_of) patches << patch(owner, faces);
  return patches;
}

data loaded_walls(const SloshingTank& tank, const TankMesh& mesh) {
  data walls(data::type::list);
  for (const std::string& wall : tank.loaded_walls) {
    data one;
    one.set("wall", wall);
    one.set("patches",
            mesh.cut() ? fmt::format("{}", fmt::join(patches_of(*mesh.cut(), wall), " ")) : wall);
    walls << one;
  }
  return walls;
}

// Each snapshot is written once, as its function object ends before twice its time.
data snapshots(const SloshingTank& tank) {
  data list(data::type::list);
  for (std::size_t i = 0; i < tank.snapshot_times.size(); ++i) {
    data snapshot;
    snapshot.set("name", fmt::format("snapshot_{}", i));
    snapshot.set("time", number(tank.snapshot_times[i]));
    snapshot.set("time_end", number(1.5 * tank.snapshot_times[i]));
    list << snapshot;
  }
  return list;
}

// Sets what differs between two dimensions and half of a gap in three, where GAMG took 9 % less
// time than PCG at the start of an oil's roll, on 90 x 8 x 51 cells.
void set_layers(const Layers& layers, data& values) {
  const bool is_half_gap = layers.is_half_gap();
  values.set("half_gap", data(is_half_gap));
  values.set("layers", number(layers.count()));
  values.set("layers_depth", number(layers.depth()));
  values.set("layers_expansion", number(layers.expansion()));
  values.set("measured_y", number(layers.measured_y()));
  values.set("side_patch", is_half_gap ? "middleOfGap" : "frontAndBack");
  values.set("side_type", is_half_gap ? "symmetryPlane" : "empty");
  values.set("side_flux", is_half_gap ? "uniform 0" : "nonuniform List<scalar> 0()");
  values.set("pressure_solver", is_half_gap ? "solver GAMG; smoother DICGaussSeidel"
                                            : "solver PCG; preconditioner DIC");
}

}  // namespace

data template_values(const SloshingTank& tank) {
  const TankMesh mesh(tank);
  const BlockMesh block_mesh = openfoam::block_mesh(mesh);
  const Cell reference = mesh.reference_cell();
  data values;
  const auto set = [&values](const char* name, double value) { values.set(name, number(value)); };
  set("roof_z", tank.height - mesh.origin_z());
  set("bottom_z", 0 - mesh.origin_z());
  set("left_x", 0 - mesh.origin_x());
  set("right_x", tank.length - mesh.origin_x());
  values.set("vertices", block_mesh.vertices);
  values.set("blocks", blocks(block_mesh.hexahedra));
  values.set("wall_patches", wall_patches(tank, block_mesh));
  values.set("side_faces", block_mesh.side_faces);
  set_layers(mesh.layers(), values);
  set("cell_count", mesh.cells_in_all_layers());
  set("gravity", tank.gravity);
  set("liquid_density", tank.liquid.density);
  set("liquid_kinematic_viscosity", tank.liquid.kinematic_viscosity);
  set("gas_density", tank.gas.density);
  set("gas_kinematic_viscosity", tank.gas.kinematic_viscosity);
  values.set("compressible", data(is_compressible(tank)));
  set("initial_pressure", is_compressible(tank) ? atmosphere : 0);
  set("level_z", tank.fill_depth - mesh.origin_z());
  set_compressible_fluids(tank, values);
  values.set("porous_medium", porous_medium(tank));
  values.set("initial_velocity", initial_field(tank, mesh));
  values.set("program", program_of(tank));
  values.set("wall_condition", tank.no_slip ? "noSlip" : "slip");
  set("duration", tank.duration);
  set("sample_interval", tank.sample_interval);
  set("max_time_step", max_time_step(tank));
  set("first_time_step", first_time_step(tank));
  set("courant_number", tank.courant_number);
  set("interface_courant_number", tank.interface_courant_number);
  set("outer_corrections", tank.outer_corrections);
  set("pressure_corrections", pressure_corrections(tank));
  set("processes", tank.processes);
  const Corner reference_place = mesh.cut() || mesh.is_graded()
                                     ? mesh.inside(reference)
                                     : Corner{(reference.column + 0.5) * tank.length / tank.cells_x,
                                              (reference.row + 0.5) * tank.height / tank.cells_z};
  set("reference_x", reference_place.x - mesh.origin_x());
  set("reference_z", reference_place.z - mesh.origin_z());
  values.set("cut_mesh", data(mesh.cut() != nullptr));
  values.set("face_normal_gradient", mesh.cut() ? "limited corrected 0.5" : "orthogonal");
  set("non_orthogonal_corrections", mesh.cut() ? 1 : 0);
  values.set("liquid_fractions", liquid_fractions(tank, mesh));
  const data table = motion_table(tank);
  set("motion_count", table.list_value().size());
  values.set("motion", table);
  values.set("columns", column_boxes(tank, mesh));
  values.set("bottom_row", bottom_row(tank, mesh));
  values.set("gauge_cells", gauge_cells(tank, mesh));
  values.set("wall_pressure", wall_pressure(tank, mesh));
  values.set("probe_cells", probe_cells(tank, mesh));
  values.set("loaded_walls", loaded_walls(tank, mesh));
  values.set("gas_pressure", data(reads_gas_pressure(tank)));
  values.set("momentum", data(!tank.roll));
  values.set("snapshots", snapshots(tank));
  return values;
}

}  // namespace slosh::openfoam
