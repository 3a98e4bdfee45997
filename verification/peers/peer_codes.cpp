#include "verification/peers/peer_codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/peers/written_files.hpp"

namespace slosh {

// Each of these is defined in the file of its code.
using Writer = void(const HandedCase&, const std::filesystem::path&);
Writer write_csv_case, write_dualsphysics_case, write_openfoam_case, write_pysph_case;

const std::vector<PeerCode>& peer_codes() {
  static const std::vector<PeerCode> codes{
      {"dualsphysics", "DualSPHysics 5.4", write_dualsphysics_case},
      {"pysph", "PySPH", write_pysph_case},
      {"openfoam", "interFoam (OpenFOAM v1912)", write_openfoam_case},
      {"csv", "any code, as tables", write_csv_case, true}};
  return codes;
}

std::vector<std::string> peer_code_names() {
  std::vector<std::string> names;
  for (const PeerCode& code : peer_codes()) names.push_back(code.name);
  return names;
}

void write_for_code(const std::string& name, const HandedCase& handed) {
  const auto& codes = peer_codes();
  const auto code = std::find_if(codes.begin(), codes.end(),
                                 [&](const PeerCode& one) { return name == one.name; });
  if (code == codes.end()) throw std::invalid_argument("no code " + name);
  const TankDefinition& tank = handed.definition.tank;
  if (!is_rectangle(tank) && !code->takes_outline)
    refuse_for_code(handed.definition, tank.diameter ? "tank.diameter_m" : "tank.outline_m",
                    fmt::format("a rectangle, length_m and height_m, for {}", code->title));
  make_whole_directory(handed.place, [&](const std::filesystem::path& directory) {
    code->write(handed, directory);
  });
}

}  // namespace slosh
