#include "verification/import/particle_table.hpp"

#include <gtest/gtest.h>

#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::particle_table_test {
namespace {

std::vector<ParticlesAt> read(const std::string& text, const ParticleColumns& columns = {}) {
  const Workspace workspace;
  return read_particle_table(workspace.write("p.csv", text), columns);
}

std::string complaint_of(const std::string& text, const ParticleColumns& columns = {}) {
  const std::string message = message_of<CaseFileError>([&] { read(text, columns); });
  return message.empty() ? "" : message.substr(message.find("p.csv"));
}

TEST(ParticleTable, GroupsTheRowsOfEachTime) {
  const auto moments = read("x,z,time\n0.1,0.2,0\n0.3,0.4,0\n0.15,0.25,0.5\n");
  ASSERT_EQ(moments.size(), 2u);
  EXPECT_EQ(moments[0].time, 0);
  EXPECT_EQ(moments[0].x, (std::vector<double>{0.1, 0.3}));
  EXPECT_EQ(moments[0].z, (std::vector<double>{0.2, 0.4}));
  EXPECT_TRUE(moments[0].volume.empty());
  EXPECT_EQ(moments[1].time, 0.5);
  EXPECT_EQ(moments[1].x, std::vector<double>{0.15});
}

TEST(ParticleTable, TakesColumnsByTheirNamesInTheFile) {
  const auto moments =
      read("Time [s];Pos.x [m];Pos.z [m];V [m2]\n0.1;1;2;1e-4\n", {"Time", "Pos.x", "Pos.z", "V"});
  ASSERT_EQ(moments.size(), 1u);
  EXPECT_EQ(moments[0].z, std::vector<double>{2});
  EXPECT_EQ(moments[0].volume, std::vector<double>{1e-4});
}

TEST(ParticleTable, RefusesWhatIsNotAParticleAtATime) {
  EXPECT_EQ(complaint_of("time,x,z\n1,0,0\n0.5,0,0\n"),
            "p.csv:3: time = 0.5: expected the last row's time, 1 s, or a later one");
  EXPECT_EQ(complaint_of("time,x,z\n1,0,nan\n"), "p.csv:2: z = nan: expected a number, in m");
  for (const char* volume : {"0", "-1e-4"})
    EXPECT_EQ(complaint_of(std::string("time,x,z,V\n1,0,0,1e-4\n1,0,0,") + volume + "\n",
                           {"time", "x", "z", "V"}),
              std::string("p.csv:3: V = ") + volume + ": expected a number > 0, in m2");
  EXPECT_EQ(complaint_of("time,x,z\n1,0\n"), "p.csv:2: row = 1,0: expected 3 values");
  EXPECT_EQ(complaint_of("time,x [mm],z\n1,0,0\n"),
            "p.csv:1: --x = x [mm]: expected a column in m");
  EXPECT_TRUE(complaint_of("time,x,y\n1,0,0\n").starts_with("p.csv:1: --z = z: expected one of"));
  EXPECT_EQ(complaint_of("time,x,z\n"), "p.csv:1: rows = none: expected at least one particle");
  EXPECT_TRUE(complaint_of("time,x,z\n1,0,0").find("cut short") != std::string::npos);
}

}  // namespace
}  // namespace slosh::particle_table_test
