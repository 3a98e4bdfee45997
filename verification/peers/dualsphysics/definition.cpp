#include "verification/peers/dualsphysics/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <utility>

#include "verification/peers/motion_table.hpp"

namespace slosh {
namespace {

using boost::property_tree::ptree;
using Attributes = std::initializer_list<std::pair<const char*, std::string>>;

// Ten digits: a lattice place and the end of a box that reaches it must not differ by a rounding.
std::string number(double value) { return fmt::format("{:.10g}", value + 0.0); }

ptree element(const Attributes& attributes) {
  ptree made;
  for (const auto& [name, value] : attributes) made.put(std::string("<xmlattr>.") + name, value);
  return made;
}

ptree text(const char* words) {
  ptree made;
  made.put_value(words);
  return made;
}

ptree value(const std::string& value) { return element({{"value", value}}); }

ptree place(double x, double z) {
  return element({{"x", number(x)}, {"y", "0"}, {"z", number(z)}});
}

void add(ptree& parent, const char* name, const ptree& child) { parent.push_back({name, child}); }

struct Box {
  double left, right, bottom, top;
};

// A box through the plane of the computation, y = 0.
void draw(ptree& commands, const char* fill, const Box& box) {
  ptree drawn;
  add(drawn, "boxfill", text(fill));
  add(drawn, "point", element({{"x", number(box.left)}, {"y", "-1"}, {"z", number(box.bottom)}}));
  add(drawn, "size",
      element(
          {{"x", number(box.right - box.left)}, {"y", "2"}, {"z", number(box.top - box.bottom)}}));
  add(commands, "drawbox", drawn);
}

// Marks of boundaries: the whole tank is one, or each wall where forces are wanted by wall.
enum Mark { tank_mark = 0, left_mark = 0, right_mark, bottom_mark, roof_mark, obstacle_mark };

class Definition {
 public:
  Definition(const CaseDefinition& definition, const DualSphysicsSettings& settings)
      : case_(definition), settings_(settings), dp_(settings.spacing) {}

  ptree casedef() const;
  ptree execution() const;

 private:
  // The lattice has its places in the middle of cells of the spacing, from half a one on.
  Box inside(const Box& box) const {
    return {box.left + dp_ / 2, box.right - dp_ / 2, box.bottom + dp_ / 2, box.top - dp_ / 2};
  }
  std::string mark(Mark own) const {
    return std::to_string(case_.wall_forces.empty() ? tank_mark : own);
  }
  double roof() const { return dualsphysics_roof(case_, dp_); }
  ptree constants() const;
  ptree normal_shapes() const;
  void draw_walls(ptree& commands) const;
  ptree commands() const;
  ptree special() const;
  ptree gauges() const;
  ptree parameters() const;

  const CaseDefinition& case_;
  const DualSphysicsSettings& settings_;
  double dp_;
};

ptree Definition::constants() const {
  ptree made;
  add(made, "gravity", element({{"x", "0"}, {"y", "0"}, {"z", number(-case_.gravity)}}));
  add(made, "rhop0", value(number(case_.liquid.density)));
  add(made, "rhopgradient", value("2"));
  add(made, "hswl", element({{"value", "0"}, {"auto", "true"}}));
  add(made, "gamma", value("7"));
  add(made, "speedsystem", element({{"value", "0"}, {"auto", "true"}}));
  add(made, "coefsound", value("20"));
  add(made, "speedsound", element({{"value", "0"}, {"auto", "true"}}));
  add(made, "coefh", value(number(dualsphysics_coefh)));
  add(made, "cflnumber", value("0.2"));
  return made;
}

// The surfaces from which GenCase takes the normals. They point into the liquid: into the tank's
// box, out of an obstacle's.
ptree Definition::normal_shapes() const {
  ptree list = element({{"name", "GeometryForNormals"}});
  add(list, "setactive", element({{"drawpoints", "0"}, {"drawshapes", "1"}}));
  add(list, "setnormalinvert", element({{"invert", "true"}}));
  add(list, "setshapemode", text("actual | bound"));
  add(list, "setmkbound", element({{"mk", "0"}}));
  draw(list, "bottom | left | right | top", {0, case_.tank.length, 0, roof()});
  if (!case_.obstacles.empty()) add(list, "setnormalinvert", element({{"invert", "false"}}));
  for (const ObstacleDefinition& one : case_.obstacles)
    draw(list, one.bottom > 0 ? "bottom | left | right | top" : "left | right | top",
         {one.left, one.right, one.bottom, one.top});
  add(list, "shapeout", element({{"file", "hdp"}}));
  add(list, "resetdraw", {});
  return list;
}

// Three layers, as the support reaches over 2 coefh sqrt(2) = 3.4 spacings.
void Definition::draw_walls(ptree& commands) const {
  const double length = case_.tank.length, height = roof();
  const double outer = 2.5 * dp_, inner = 0.5 * dp_;
  const auto wall = [&](Mark own, const Box& box) {
    add(commands, "setmkbound", element({{"mk", mark(own)}}));
    draw(commands, "solid", box);
  };
  wall(left_mark, {-outer, -inner, -outer, height + outer});
  wall(right_mark, {length + inner, length + outer, -outer, height + outer});
  wall(bottom_mark, {inner, length - inner, -outer, -inner});
  wall(roof_mark, {inner, length - inner, height + inner, height + outer});
  for (const ObstacleDefinition& one : case_.obstacles)
    wall(obstacle_mark, inside({one.left, one.right, one.bottom, one.top}));
}

ptree Definition::commands() const {
  ptree main, run = element({{"name", "GeometryForNormals"}}), made;
  add(main, "runlist", run);
  add(main, "setshapemode", text("actual | dp | bound"));
  add(main, "setdrawmode", element({{"mode", "full"}}));
  add(main, "setmkfluid", element({{"mk", "0"}}));
  draw(main, "solid",
       inside(
           {0, case_.liquid.column_width.value_or(case_.tank.length), 0, case_.liquid.fill_depth}));
  draw_walls(main);  // after the liquid, so that obstacles take its place
  add(made, "list", normal_shapes());
  add(made, "mainlist", main);
  return made;
}

ptree Definition::casedef() const {
  ptree made, geometry, definition = element({{"dp", number(dp_)}}), normals, search;
  const double margin = 12 * dp_;  // beyond the walls' layers
  add(definition, "pointref", place(dp_ / 2, dp_ / 2));
  add(definition, "pointmin", place(-margin, -margin));
  add(definition, "pointmax", place(case_.tank.length + margin, case_.tank.height + margin));
  add(geometry, "definition", definition);
  add(geometry, "commands", commands());
  add(search, "geometryfile", element({{"file", "[CaseName]_hdp_Actual.vtk"}}));
  add(search, "distanceh", element({{"v", "3"}}));
  add(normals, "norgeometry", search);
  add(made, "constantsdef", constants());
  add(made, "mkconfig", element({{"boundcount", "240"}, {"fluidcount", "9"}}));
  add(made, "geometry", geometry);
  add(made, "normals", normals);
  return made;
}

// A gauge's line spans the tank's height, so that no surface leaves it.
ptree Definition::gauges() const {
  ptree made, usual;
  const std::string interval = number(case_.sample_interval);
  add(usual, "savevtkpart", value("false"));
  add(usual, "computedt", value(interval));
  add(usual, "output", value("true"));
  add(usual, "outputdt", value(interval));
  add(made, "default", usual);
  for (const GaugeDefinition& gauge : case_.gauges) {
    ptree surface = element({{"name", "surface_" + gauge.name}});
    add(surface, "pointdp", element({{"coefdp", "0.1"}}));
    add(surface, "point0", place(gauge.x, 0));
    add(surface, "point2", place(gauge.x, roof()));
    add(made, "swl", surface);
    ptree highest = element({{"name", "highest_" + gauge.name}});
    add(highest, "point0", place(gauge.x, 0));
    add(highest, "height", value(number(roof())));
    add(highest, "distlimit", element({{"coefdp", "1"}}));
    add(made, "maxz", highest);
  }
  for (const ProbeDefinition& probe : case_.probes) {
    ptree velocity = element({{"name", "probe_" + probe.name}});
    add(velocity, "point", place(probe.x, probe.z));
    add(made, "velocity", velocity);
  }
  const auto force = [&](const std::string& name, const std::string& own) {
    ptree one = element({{"name", "on_" + name}});
    add(one, "target", element({{"mkbound", own}}));
    add(made, "force", one);
  };
  if (case_.wall_forces.empty()) force("tank", mark(tank_mark));
  for (const Wall wall : case_.wall_forces)
    force(name_of(wall, wall_names), mark(wall == Wall::left     ? left_mark
                                          : wall == Wall::right  ? right_mark
                                          : wall == Wall::bottom ? bottom_mark
                                                                 : roof_mark));
  return made;
}

ptree Definition::special() const {
  ptree made;
  if (const double velocity = initial_velocity_x(case_); velocity != 0) {
    ptree liquid = element({{"mkfluid", "0"}}), initialize;
    add(liquid, "direction", element({{"x", velocity < 0 ? "-1" : "1"}, {"y", "0"}, {"z", "0"}}));
    add(liquid, "velocity", element({{"v", number(std::abs(velocity))}}));
    add(initialize, "fluidvelocity", liquid);
    add(made, "initialize", initialize);
  }
  if (!settings_.acceleration_file.empty()) {
    ptree input = element({{"mkfluid", "0"}}), inputs;
    const auto& roll = case_.motion.roll;
    add(input, "acccentre", place(roll ? roll->axis_x : 0, roll ? roll->axis_z : 0));
    add(input, "globalgravity", value("1"));
    add(input, "acctimesfile", value(settings_.acceleration_file));
    add(inputs, "accinput", input);
    add(made, "accinputs", inputs);
  }
  add(made, "gauges", gauges());
  return made;
}

ptree Definition::parameters() const {
  const double last = case_.duration + case_.sample_interval;  // past the last sample
  ptree made;
  const std::pair<const char*, std::string> keys[] = {
      {"SavePosDouble", "1"},    {"Boundary", "2"},
      {"SlipMode", "1"},         {"StepAlgorithm", "2"},
      {"Kernel", "2"},           {"ViscoTreatment", "1"},
      {"Visco", "0.01"},         {"ViscoBoundFactor", "1"},
      {"DensityDT", "2"},        {"DensityDTvalue", "0.1"},
      {"Shifting", "0"},         {"RigidAlgorithm", "1"},
      {"CoefDtMin", "0.05"},     {"DtAllParticles", "0"},
      {"TimeMax", number(last)}, {"TimeOut", number(std::max(0.1, case_.sample_interval))}};
  for (const auto& [key, its] : keys)
    add(made, "parameter", element({{"key", key}, {"value", its}}));
  ptree domain;
  add(domain, "posmin", element({{"x", "default - 5%"}, {"y", "default"}, {"z", "default"}}));
  add(domain, "posmax", element({{"x", "default + 5%"}, {"y", "default"}, {"z", "default + 10%"}}));
  add(made, "simulationdomain", domain);
  return made;
}

ptree Definition::execution() const {
  ptree made;
  add(made, "special", special());
  add(made, "parameters", parameters());
  return made;
}

}  // namespace

double dualsphysics_roof(const CaseDefinition& definition, double spacing) {
  return std::round(definition.tank.height / spacing) * spacing;
}

std::string dualsphysics_definition(const CaseDefinition& definition,
                                    const DualSphysicsSettings& settings) {
  const Definition parts(definition, settings);
  ptree root, whole;
  add(root, "casedef", parts.casedef());
  add(root, "execution", parts.execution());
  add(whole, "case", root);
  std::ostringstream stream;
  boost::property_tree::write_xml(
      stream, whole, boost::property_tree::xml_writer_settings<std::string>(' ', 2, "UTF-8"));
  return stream.str();
}

}  // namespace slosh
