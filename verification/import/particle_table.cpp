#include "verification/import/particle_table.hpp"

#include <fmt/format.h>

#include "verification/import/table_head.hpp"

namespace slosh {

// It is defined in csv_head.cpp.
TableHead read_csv_head(TableReader& reader, const SeriesSource& source);

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
  do {
    if (trimmed(reader.line()).empty()) continue;
    const auto fields = fields_of_row(reader, head);
    const double now = reader.number(columns.time, fields[time], "s");
    if (moments.empty() || now != moments.back().time) {
      if (!moments.empty() && !(now > moments.back().time))
        reader.refuse(
            columns.time, fields[time],
            fmt::format("the last row's time, {} s, or a later one", moments.back().time));
      moments.push_back({now, {}, {}, {}});
    }
    moments.back().x.push_back(reader.number(columns.x, fields[x], "m"));
    moments.back().z.push_back(reader.number(columns.z, fields[z], "m"));
    if (!columns.volume.empty())
      moments.back().volume.push_back(reader.number(columns.volume, fields[volume], "m2"));
  } while (reader.next());
  if (moments.empty()) reader.refuse("rows", "none", "at least one particle");
  return moments;
}

}  // namespace

std::vector<ParticlesAt> read_particle_table(const std::filesystem::path& file,
                                             const ParticleColumns& columns) {
  if (!std::filesystem::is_regular_file(file))
    throw CaseFileError("file = " + file.string() + ": expected a file; there is none");
  TableReader reader(file);
  SeriesSource source;
  source.time_column = columns.time;
  const TableHead head = read_csv_head(reader, source);
  return read_rows(reader, head, columns);
}

}  // namespace slosh
