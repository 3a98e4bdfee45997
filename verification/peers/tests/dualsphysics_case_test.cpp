// The definition that is written for GenCase, read by a parser of XML and compared with one that
// GenCase has read.
#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "verification/peers/tests/handed.hpp"

namespace slosh::dualsphysics_case_test {
namespace {

namespace fs = std::filesystem;
using boost::property_tree::ptree;

ptree parsed(const std::string& text) {
  std::istringstream stream(text);
  ptree tree;
  boost::property_tree::read_xml(stream, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree;
}

const ptree& real_definition() {
  static const ptree tree = parsed(
      read_bytes(SLOSH_SOURCE_DIR "/verification/tests/imports/dualsphysics/tank_25mm_Def.xml"));
  return tree;
}

// All paths of elements and attributes: "case.casedef.geometry.definition@dp".
void add_paths(const ptree& tree, const std::string& above, std::set<std::string>& paths) {
  for (const auto& [name, child] : tree) {
    if (name == "<xmlattr>") {
      for (const auto& attribute : child) paths.insert(above + "@" + attribute.first);
    } else {
      paths.insert(above + "." + name);
      add_paths(child, above + "." + name, paths);
    }
  }
}

double number(const ptree& element, const char* attribute) {
  return element.get<double>(std::string("<xmlattr>.") + attribute);
}

// The solid boxes in the order in which they are drawn, as left, right, bottom and top, and their
// marks: "fluid0", "bound1", ...
struct Drawn {
  std::string mark;
  double left, right, bottom, top;
};

std::vector<Drawn> drawn_boxes(const ptree& definition) {
  std::vector<Drawn> boxes;
  std::string mark;
  for (const auto& [name, child] :
       definition.get_child("case.casedef.geometry.commands.mainlist")) {
    if (name == "setmkfluid") mark = "fluid" + child.get<std::string>("<xmlattr>.mk");
    if (name == "setmkbound") mark = "bound" + child.get<std::string>("<xmlattr>.mk");
    if (name != "drawbox") continue;
    const double x = number(child.get_child("point"), "x"),
                 z = number(child.get_child("point"), "z");
    boxes.push_back({mark, x, x + number(child.get_child("size"), "x"), z,
                     z + number(child.get_child("size"), "z")});
  }
  return boxes;
}

// How many places of the lattice of GenCase, pointref + i dp, are in the box.
int places(const Drawn& box, double dp) {
  const auto along = [&](double begin, double end) {
    return static_cast<int>(std::floor((end - dp / 2) / dp + 1e-6) -
                            std::ceil((begin - dp / 2) / dp - 1e-6)) +
           1;
  };
  return along(box.left, box.right) * along(box.bottom, box.top);
}

// A name that nothing defines leaves an empty text in a template.
TEST(DualSphysicsCase, FillsEveryPlaceOfItsTemplate) {
  for (const char* name : {"zhao2021_mild_roll", "surge_with_baffle"}) {
    Handed handed(name);
    const std::string text = handed.to("dualsphysics", 0.005).file(name + std::string("_Def.xml"));
    for (const char* empty : {"\"\"", "{{", "><"})
      EXPECT_EQ(text.find(empty), text.npos) << name << empty;
  }
}

TEST(DualSphysicsCase, UsesNoElementThatGenCaseHasNotRead) {
  std::set<std::string> known, written;
  add_paths(real_definition(), "", known);
  // Documented in _FmtXML_AccInput.xml of DualSPHysics.
  known.insert(".case.execution.special.accinputs.accinput.acctimesfile");
  known.insert(".case.execution.special.accinputs.accinput.acctimesfile@value");
  Handed handed("li2010_small_amplitude");
  add_paths(parsed(handed.to("dualsphysics", 0.025).file("li2010_small_amplitude_Def.xml")), "",
            written);
  EXPECT_GT(written.size(), 60u);
  for (const std::string& path : written) EXPECT_TRUE(known.contains(path)) << path;
}

TEST(DualSphysicsCase, SaysWhatTheDefinitionThatGenCaseHasReadSays) {
  Handed handed("li2010_small_amplitude");
  const ptree tree =
      parsed(handed.to("dualsphysics", 0.025).file("li2010_small_amplitude_Def.xml"));
  const ptree& real = real_definition();
  for (const char* same :
       {"case.casedef.constantsdef", "case.casedef.normals", "case.execution.special.initialize"})
    EXPECT_TRUE(tree.get_child(same) == real.get_child(same)) << same;
  const std::vector<Drawn> boxes = drawn_boxes(tree), others = drawn_boxes(real);
  ASSERT_EQ(boxes.size(), 5u);  // the roof is ours alone
  EXPECT_EQ(boxes[0].mark, "fluid0");
  EXPECT_EQ(places(boxes[0], 0.025), 40 * 14);
  EXPECT_EQ(places(boxes[0], 0.025), places(others[0], 0.025));
  int walls = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i) walls += places(boxes[i], 0.025);
  EXPECT_EQ(walls, 2 * 3 * 46 + 2 * 3 * 40);
}

TEST(DualSphysicsCase, PutsItsGaugesIntoTheTankFromBottomToRoof) {
  Handed handed(replaced(plain_case, "[comparison]",
                         "[[probe]]\nname = \"middle\"\nx_m = 0.5\nz_m = 0.2\n[comparison]"));
  const ptree gauges = parsed(handed.to("dualsphysics").file("plain_Def.xml"))
                           .get_child("case.execution.special.gauges");
  EXPECT_EQ(number(gauges.get_child("default.outputdt"), "value"), 0.02);
  const ptree& surface = gauges.get_child("swl");
  EXPECT_EQ(surface.get<std::string>("<xmlattr>.name"), "surface_right");
  for (const char* end : {"point0", "point2"})
    EXPECT_EQ(number(surface.get_child(end), "x"), 0.95) << end;
  EXPECT_EQ(number(surface.get_child("point0"), "z"), 0);
  EXPECT_NEAR(number(surface.get_child("point2"), "z"), 0.6, 1e-9);
  EXPECT_NEAR(number(gauges.get_child("maxz.height"), "value"), 0.6, 1e-9);
  EXPECT_EQ(number(gauges.get_child("velocity.point"), "z"), 0.2);
  EXPECT_EQ(gauges.get<std::string>("force.target.<xmlattr>.mkbound"), "0");
}

TEST(DualSphysicsCase, SetsTheLiquidOffAgainstTheTankOfTheEarthsFrameAlone) {
  const auto special = [](const std::string& text) {
    Handed handed(text);
    return parsed(handed.to("dualsphysics").file("plain_Def.xml"))
        .get_child("case.execution.special");
  };
  const ptree moves = special(moving(surges));
  EXPECT_EQ(number(moves.get_child("initialize.fluidvelocity.direction"), "x"), -1);
  EXPECT_NEAR(number(moves.get_child("initialize.fluidvelocity.velocity"), "v"), 0.034, 1e-9);
  EXPECT_EQ(moves.get<std::string>("accinputs.accinput.acctimesfile.<xmlattr>.value"),
            "plain_acceleration.csv");
  EXPECT_EQ(moves.get<std::string>("accinputs.accinput.globalgravity.<xmlattr>.value"), "1");
  const ptree other = special(replaced(moving(surges), "start = \"earth\"", "start = \"tank\""));
  EXPECT_EQ(other.count("initialize"), 0u);
  EXPECT_EQ(special(plain_case).count("accinputs"), 0u);
}

TEST(DualSphysicsCase, DrawsObstaclesInPlaceOfLiquidWithNormalsIntoIt) {
  Handed handed("surge_with_baffle");
  const ptree tree = parsed(handed.to("dualsphysics", 0.01).file("surge_with_baffle_Def.xml"));
  const std::vector<Drawn> boxes = drawn_boxes(tree);
  ASSERT_EQ(boxes.size(), 6u);
  EXPECT_EQ(boxes.front().mark, "fluid0");
  EXPECT_EQ(places(boxes.back(), 0.01), 4 * 14);
  EXPECT_NEAR(boxes.back().left, 0.485, 1e-9);
  std::vector<std::string> order;
  for (const auto& [name, child] : tree.get_child("case.casedef.geometry.commands.list")) {
    if (name == "setnormalinvert") order.push_back(child.get<std::string>("<xmlattr>.invert"));
    if (name == "drawbox") order.push_back(child.get<std::string>("boxfill"));
  }
  EXPECT_EQ(order, (std::vector<std::string>{"true", "bottom | left | right | top", "false",
                                             "left | right | top"}));
}

TEST(DualSphysicsCase, RollsAboutTheAxisAndEndsAfterTheLastSample) {
  Handed handed("zhao2021_mild_roll");
  const ptree execution =
      parsed(handed.to("dualsphysics", 0.005).file("zhao2021_mild_roll_Def.xml"))
          .get_child("case.execution");
  const ptree& centre = execution.get_child("special.accinputs.accinput.acccentre");
  EXPECT_EQ(number(centre, "x"), 0.46);
  EXPECT_EQ(number(centre, "z"), 0.31);
  std::map<std::string, std::string> parameters;
  for (const auto& [name, child] : execution.get_child("parameters"))
    if (name == "parameter")
      parameters[child.get<std::string>("<xmlattr>.key")] =
          child.get<std::string>("<xmlattr>.value");
  EXPECT_NEAR(std::stod(parameters.at("TimeMax")), 10.01, 1e-9);
  EXPECT_EQ(parameters.at("Boundary"), "2");
  EXPECT_NE(handed.file("README.md").find("DualSPHysics#296"), std::string::npos);
}

TEST(DualSphysicsCase, GivesEachWallAMarkWhereForcesAreWantedByWall) {
  Handed handed(
      replaced(plain_case, "tags = []", "tags = []\nwall_forces = [\"right\", \"roof\"]"));
  const ptree tree = parsed(handed.to("dualsphysics").file("plain_Def.xml"));
  std::set<std::string> marks;
  for (const Drawn& box : drawn_boxes(tree)) marks.insert(box.mark);
  EXPECT_EQ(marks, (std::set<std::string>{"fluid0", "bound0", "bound1", "bound2", "bound3"}));
  std::map<std::string, std::string> targets;
  for (const auto& [name, child] : tree.get_child("case.execution.special.gauges"))
    if (name == "force")
      targets[child.get<std::string>("<xmlattr>.name")] =
          child.get<std::string>("target.<xmlattr>.mkbound");
  EXPECT_EQ(targets, (std::map<std::string, std::string>{{"on_right", "1"}, {"on_roof", "3"}}));
}

TEST(DualSphysicsCase, TakesItsGaugesBackByARunOfTheCase) {
  Handed handed(moving(surges));
  const ExternalRun run = handed.to("dualsphysics").run();
  EXPECT_EQ(run.command.front(), (handed.directory() / "run.sh").string());
  EXPECT_EQ(run.method, "dualsphysics");
  EXPECT_EQ(run.particle_spacing, 0.05);
  EXPECT_EQ(run.inputs.size(), 3u);  // the definition, the acceleration, the script
  std::set<std::string> quantities;
  for (const SeriesSource& source : run.series) {
    quantities.insert(source.quantity);
    if (source.quantity == "elevation@right") {
      EXPECT_EQ(source.file, "GaugesSWL_surface_right.csv");
      EXPECT_EQ(source.format, "dualsphysics_gauge");
      EXPECT_TRUE(source.first_is_zero);
    }
  }
  EXPECT_EQ(quantities, (std::set<std::string>{"elevation@right", "highest_surface@right",
                                               "force_x", "force_z"}));
}

}  // namespace
}  // namespace slosh::dualsphysics_case_test
