#include "openfoam_cases/write_case.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/tank_mesh.hpp"
#include "openfoam_cases/outline/poly_mesh.hpp"
#include "openfoam_cases/template_values.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;

// An undefined name in a template is an error; mustache would render it as an empty string.
class StrictContext : public kainjow::mustache::context<std::string> {
 public:
  explicit StrictContext(const data* values) : context(values) {}
  const data* get(const std::string& name) const override {
    const data* value = context::get(name);
    if (value == nullptr) throw std::invalid_argument("nothing defines {{" + name + "}}");
    return value;
  }
};

// Returns whether the tank's case has no such file: that of another program or of another mesh.
bool is_left_out(const SloshingTank& tank, const fs::path& file) {
  const std::string name = file.filename();
  if (name == "blockMeshDict") return !tank.outline.empty();
  if (name == "transportProperties") return is_compressible(tank);
  const bool of_compressible =
      name == "p" || name == "T" || name == "hRef" || name.starts_with("thermophysicalProperties");
  return of_compressible && !is_compressible(tank);
}

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

void write_case(const SloshingTank& tank, const fs::path& template_directory,
                const fs::path& case_directory) {
  check_tank(tank);
  // The series of an earlier run would be taken for those of this run.
  if (fs::exists(case_directory) && !fs::is_empty(case_directory)) {
    throw std::invalid_argument("case directory " + case_directory.string() + " is not empty");
  }
  const data values = template_values(tank);
  fs::create_directories(case_directory);
  for (const auto& entry : fs::recursive_directory_iterator(template_directory)) {
    const fs::path target = case_directory / fs::relative(entry.path(), template_directory);
    if (is_left_out(tank, entry.path())) continue;
    if (entry.is_directory()) {
      fs::create_directories(target);
    } else {
      fill_template(entry.path(), target, values);
    }
  }
  if (tank.outline.empty()) return;
  const TankMesh mesh(tank);
  write_poly_mesh(*mesh.cut(), {mesh.origin_x(), mesh.origin_z()}, !tank.loaded_walls.empty(),
                  case_directory);
  if (tank.processes > 1) write_decomposition(*mesh.cut(), case_directory);
}

}  // namespace slosh::openfoam
