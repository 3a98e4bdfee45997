#include "verification/import/particle_table.hpp"

#include <fmt/format.h>

#include "verification/input/tables/series_files.hpp"
#include "verification/input/tables/table_rows.hpp"

namespace slosh {
namespace {

std::size_t place_of(const TableReader& reader, const TableHead& head, const char* key,
                     const std::string& name, const std::string& unit) {
  const std::size_t place = column_place(reader, head, key, name);
  const std::string& in_file = head.columns[place].unit;
  if (!in_file.empty() && in_file != unit)
    throw table_error(reader.file(), head.line, key, name + " [" + in_file + "]",
                      "a column in " + unit);
  return place;
}

std::vector<ParticlesAt> read_rows(TableReader& reader, const TableHead& head,
                                   const ParticleColumns& columns) {
  const std::size_t time = place_of(reader, head, "--time", columns.time, "s"),
                    x = place_of(reader, head, "--x", columns.x, "m"),
                    z = place_of(reader, head, "--z", columns.z, "m"),
                    volume = columns.volume.empty()
                                 ? 0
                                 : place_of(reader, head, "--volume", columns.volume, "m2");
  std::vector<ParticlesAt> moments;
  TableRows rows(reader, head);
  while (rows.next()) {
    const auto& fields = rows.fields();
    const double now = reader.number(columns.time, fields[time], "s");
    if (moments.empty() || now != moments.back().time) {
      if (!moments.empty() && !(now > moments.back().time))
        reader.refuse(
            columns.time, fields[time],
            fmt::format("the last row's time, {} s, or a later one", moments.back().time));
      moments.push_back({now, {}, {}, {}, {}});
    }
    moments.back().x.push_back(reader.number(columns.x, fields[x], "m"));
    moments.back().z.push_back(reader.number(columns.z, fields[z], "m"));
    moments.back().line.push_back(reader.line_number());
    if (columns.volume.empty()) continue;
    moments.back().volume.push_back(reader.number(columns.volume, fields[volume], "m2"));
    if (!(moments.back().volume.back() > 0))
      reader.refuse(columns.volume, fields[volume], "a number > 0, in m2");
  }
  if (moments.empty()) reader.refuse("rows", "none", "at least one particle");
  return moments;
}

}  // namespace

std::vector<ParticlesAt> read_particle_table(const std::filesystem::path& file,
                                             const ParticleColumns& columns) {
  if (!std::filesystem::is_regular_file(file))
    throw CaseFileError("file = " + file.string() + ": expected a file; " + no_file_at(file));
  TableReader reader(file);
  return read_rows(reader, find_head(reader, {columns.time, columns.x, columns.z}), columns);
}

}  // namespace slosh
