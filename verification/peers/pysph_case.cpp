// A case for PySPH: the driver that Slosh ships, and the file that it reads.
#include <fmt/format.h>

#include "verification/files/content_hash.hpp"
#include "verification/peers/tank_file.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* driver = "pysph_tank.py";

// What read_pysph_run() of the case-file parser refuses too.
void require_for_pysph(const HandedCase& handed) {
  const CaseDefinition& definition = handed.definition;
  const auto refuse = [&](const char* key, const std::string& expected) {
    refuse_for_code(definition, key, expected + ", for PySPH");
  };
  if (definition.motion.roll) refuse("motion.roll", "a tank that does not roll");
  if (!definition.obstacles.empty()) refuse("obstacle", "a tank without obstacles");
  if (definition.liquid.column_width)
    refuse("liquid.column_width_m", "a liquid that fills the tank from wall to wall");
  if (definition.tank.breadth) refuse("tank.breadth_m", "a tank whose gap walls do not count");
  if (definition.gauges.empty())
    throw CaseFileError(definition.file.string() +
                        ": gauge: expected at least one [[gauge]], for PySPH");
  if (definition.gravity == 0) refuse("gravity_m_s2", "a number > 0, in m/s2");
  for (const double size : {definition.tank.length, definition.liquid.fill_depth})
    if (!is_whole_multiple(size, handed.spacing))
      throw CaseFileError(fmt::format(
          "--spacing: {}: expected a whole fraction of the tank's length and of the fill depth, "
          "{:.4g} and {:.4g} m, for PySPH",
          handed.spacing, definition.tank.length, definition.liquid.fill_depth));
}

}  // namespace

void write_pysph_case(const HandedCase& handed, const fs::path& directory) {
  require_for_pysph(handed);
  write_text(directory / "tank.json", tank_file(handed.definition));
  write_script(directory / driver, read_bytes(peers_directory() / driver));
  const std::string name = run_name("pysph", handed.spacing);
  const data told = values({{"spacing", fmt::format("{}", handed.spacing)},
                            {"name", handed.definition.name},
                            {"run", name}});
  write_script(directory / "run.sh", filled("pysph/run.sh.mustache", told));
  write_text(directory / "run.toml",
             fmt::format("# Slosh starts the driver that it ships, which is the one in this "
                         "directory.\n[[run]]\nname = \"{}\"\nsolver = \"pysph\"\nscheme = "
                         "\"delta_sph\"\nparticle_spacing_m = {}\n",
                         name, handed.spacing));
  write_text(directory / "README.md",
             readme_head(handed, "PySPH") + filled("pysph/README.md.mustache", told));
}

}  // namespace slosh
