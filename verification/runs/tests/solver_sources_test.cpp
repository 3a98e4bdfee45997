#include "verification/runs/solver_sources.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "verification/tests/temporary_directory.hpp"

namespace slosh::solver_sources_test {
namespace {

const std::string source = R"code(
#include "parts/wave.hpp"
#define TWICE(x) \
  (2 * (x))
// Returns the speed of a long wave [m/s].
double speed(double depth) {
  constexpr double g = 9.81;  /* of the earth */
  if (depth<=0) return 0; const char quote = '"', mark = '\'';
  return std::sqrt(g * depth) + TWICE(1e-3) + -1'000. * (quote == mark);
}
const char* const text = "a // b  c", *raw = R"(")" // )";
)code";

TEST(SolverSources, HaveTheSameTokensWhateverTheirCommentsAndLayout) {
  const std::string laid_out = R"code(#include "parts/wave.hpp"
#define TWICE( x ) (2*(x))   // twice
double
speed( double depth )   // another word
{
  constexpr double g=9.81;
  if (depth <= 0)
    return 0;
  /* // */ const char quote='"',mark='\'';
  return std::sqrt(g*depth)
       + TWICE(1e-3) + - 1'000.*(quote==mark);
}
const char *const text = "a // b  c", * raw = R"(")" // )";
;)code";
  EXPECT_EQ(tokens_of(laid_out.substr(0, laid_out.rfind('\n') + 1)), tokens_of(source));
}

TEST(SolverSources, ChangeWithEachExpression) {
  struct Change {
    const char *from, *to;
  };
  for (const Change& change : {Change{"9.81", "9.80"},
                               {"g * depth", "g / depth"},
                               {"<=", "<"},
                               {"1e-3", "1e+3"},
                               {"1e-3", "1e-4"},
                               {"'000", "'001"},
                               {"b  c", "b c"},
                               {"// b", "/* b"},
                               {"(2 *", "(3 *"},
                               {"wave.hpp", "waves.hpp"},
                               {"'\\''", "'\\\\'"},
                               {"R\"(\")", "R\"()"},
                               {"double g", "float g"},
                               {"return 0", "return 00"}}) {
    std::string changed = source;
    const auto at = changed.find(change.from);
    ASSERT_NE(at, changed.npos) << change.from;
    changed.replace(at, std::string(change.from).size(), change.to);
    EXPECT_NE(tokens_of(changed), tokens_of(source)) << change.from << " -> " << change.to;
  }
}

class SourcesOnDisk : public testing::Test {
 protected:
  SourcesOnDisk() {
    std::filesystem::create_directory(root() / "parts");
    write("run.cpp", "#include \"parts/wave.hpp\"\n#include <cmath>\ndouble run();\n");
    write("parts/wave.hpp", "#include \"parts/depth.hpp\"\nint wave;\n");
    write("parts/depth.hpp", "int depth;\n");
  }
  std::filesystem::path root() const { return directory.path(); }
  void write(const char* name, const char* text) { std::ofstream(root() / name) << text; }
  std::string text(const std::set<std::string>& left_out = {}) const {
    return text_of_sources(root(), {"run.cpp"}, left_out);
  }

  TemporaryDirectory directory;
};

TEST_F(SourcesOnDisk, AreFollowedThroughTheHeadersThatTheyInclude) {
  const std::string before = text();
  EXPECT_EQ(before,
            "== parts/depth.hpp\nint depth ;\n"
            "== parts/wave.hpp\n# include \"parts/depth.hpp\"\nint wave ;\n"
            "== run.cpp\n# include \"parts/wave.hpp\"\n# include < cmath >\ndouble run ( ) ;\n");
  write("parts/depth.hpp", "int  depth;  // [m]\n");
  EXPECT_EQ(text(), before);
  write("parts/depth.hpp", "int depth = 1;\n");
  EXPECT_NE(text(), before);
}

TEST_F(SourcesOnDisk, AreNotThoseThatAreLeftOut) {
  const std::string without = text({"parts/wave.hpp"});
  EXPECT_EQ(without.find("int"), without.npos);
  write("parts/depth.hpp", "int depth = 1;\n");
  EXPECT_EQ(text({"parts/wave.hpp"}), without);
}

TEST_F(SourcesOnDisk, MustBeThere) {
  std::filesystem::remove(root() / "parts/depth.hpp");
  EXPECT_THROW(text(), std::filesystem::filesystem_error);
}

}  // namespace
}  // namespace slosh::solver_sources_test
