#include "verification/runs/cost_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

constexpr double shortest = 2;          // [s]: a shorter run measures its start, not its solver
constexpr std::size_t recent = 30;      // runs
constexpr std::streamoff tail = 65536;  // [byte], some 1500 lines

std::filesystem::path file_of(const ResultStore& store) { return store.root() / "costs.txt"; }

// Returns the end of the file without its first line, which may be cut.
std::string last_lines(const std::filesystem::path& file) {
  if (!is_plain_file(file)) return "";  // a pipe would be waited for
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg(), begin = std::max<std::streamoff>(size - tail, 0);
  stream.seekg(begin);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return begin > 0 ? text.substr(std::min(text.find('\n'), text.size())) : text;
}

}  // namespace

void record_cost(const CostRecord& record, const ResultStore& store) {
  if (!(record.taken >= shortest) || !(record.modelled > 0)) return;
  require_no_input(file_of(store));
  if (std::filesystem::exists(file_of(store)) && !is_plain_file(file_of(store))) return;
  // A short line is one write, so that the lines of runs that end together do not mix.
  std::ofstream(file_of(store), std::ios::app)
      << fmt::format("{} {:.4g} {:.4g}\n", record.solver, record.modelled, record.taken);
}

std::optional<double> machine_factor(const std::string& solver, const ResultStore& store) {
  std::vector<double> factors;
  std::istringstream lines(last_lines(file_of(store)));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    CostRecord record;
    const bool is_record =
        static_cast<bool>(words >> record.solver >> record.modelled >> record.taken);
    if (is_record && record.solver == solver && record.modelled > 0 && record.taken > 0)
      factors.push_back(record.taken / record.modelled);
  }
  if (factors.empty()) return {};
  if (factors.size() > recent) factors.erase(factors.begin(), factors.end() - recent);
  const auto middle = factors.begin() + static_cast<long>(factors.size() / 2);
  std::nth_element(factors.begin(), middle, factors.end());
  return *middle;
}

}  // namespace slosh
