#include "verification/solvers/particles/state_file.hpp"

#include <fmt/format.h>

#include "verification/files/hdf5_handles.hpp"
#include "verification/files/sealed_file.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {
namespace {

using hdf5::Handle;

constexpr SealedKind kind{"state", 1};

void write_part(hid_t parent, const std::string& name, const std::vector<std::string>& texts) {
  hdf5::write_texts(parent, name, texts);
}
void read_part(hid_t parent, const std::string& name, std::vector<std::string>& texts) {
  texts = hdf5::read_texts(parent, name);
}

void write_part(hid_t parent, const std::string& name, const std::vector<double>& values) {
  hdf5::write_numbers(parent, name, values);
}
void read_part(hid_t parent, const std::string& name, std::vector<double>& values) {
  values = hdf5::read_numbers(parent, name);
}

void write_part(hid_t parent, const std::string& name,
                const std::map<std::string, double>& numbers) {
  const Handle group = hdf5::create_group(parent, name);
  for (const auto& [key, value] : numbers) hdf5::write_attribute(group, key, value);
}
void read_part(hid_t parent, const std::string& name, std::map<std::string, double>& numbers) {
  const Handle group = hdf5::open_group(parent, name);
  for (const std::string& key : hdf5::attribute_names(group))
    numbers[key] = hdf5::read_number_attribute(group, key);
}

void write_part(hid_t parent, const std::string& name, const sph::History& history) {
  const Handle group = hdf5::create_group(parent, name);
  write_part(group, "time", history.time);
  write_part(group, "value", history.value);
}
void read_part(hid_t parent, const std::string& name, sph::History& history) {
  const Handle group = hdf5::open_group(parent, name);
  read_part(group, "time", history.time);
  read_part(group, "value", history.value);
}

template <class Value>
void write_part(hid_t parent, const std::string& name, const std::map<std::string, Value>& parts) {
  const Handle group = hdf5::create_group(parent, name);
  for (const auto& [key, part] : parts) write_part(group, key, part);
}
template <class Value>
void read_part(hid_t parent, const std::string& name, std::map<std::string, Value>& parts) {
  const Handle group = hdf5::open_group(parent, name);
  for (const std::string& key : hdf5::member_names(group)) read_part(group, key, parts[key]);
}

void write_part(hid_t parent, const std::string& name,
                const std::vector<sph::RecordedSeries>& series) {
  const Handle group = hdf5::create_group(parent, name);
  for (const sph::RecordedSeries& one : series) {
    write_part(group, one.name, one.history);
    hdf5::write_attribute(hdf5::open_group(group, one.name), "unit", one.unit);
  }
}
void read_part(hid_t parent, const std::string& name, std::vector<sph::RecordedSeries>& series) {
  const Handle group = hdf5::open_group(parent, name);
  for (const std::string& one : hdf5::member_names(group)) {
    series.push_back({one, hdf5::read_text_attribute(hdf5::open_group(group, one), "unit"), {}});
    read_part(group, one, series.back().history);
  }
}

}  // namespace

std::filesystem::path state_file(const std::filesystem::path& directory,
                                 const std::string& run_name) {
  return directory / (run_name + ".state.h5");
}

std::filesystem::path last_good_state_file(const std::filesystem::path& directory,
                                           const std::string& run_name) {
  return directory / (run_name + ".last_good.h5");
}

void write_state(const sph::SavedState& state, const std::string& key,
                 const std::filesystem::path& file) {
  write_sealed(kind, file, [&](hid_t root) {
    hdf5::write_attribute(root, "key", key);
    sph::SavedState::for_each_part(
        state, [&](const char* name, const auto& part) { write_part(root, name, part); });
  });
}

sph::SavedState read_state(const std::string& key, const std::filesystem::path& file) {
  sph::SavedState state;
  read_sealed(kind, file, [&](hid_t root) {
    const std::string found = hdf5::read_text_attribute(root, "key");
    if (found != key)
      throw ResultError(
          fmt::format("key = {}: expected {}, it is the state of another run, or of "
                      "this one by another build",
                      found, key));
    sph::SavedState::for_each_part(
        state, [&](const char* name, auto& part) { read_part(root, name, part); });
  });
  return state;
}

}  // namespace slosh
