#include "verification/engine/slurm_array.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>

namespace slosh {
namespace {

constexpr std::size_t places_of_array = 1000;  // MaxArraySize is 1001 unless a site changes it
constexpr double mebibyte = 1024 * 1024;
// A run's peak memory varies little between machines; Slurm kills a job that exceeds its request.
constexpr double memory_margin = 2;
constexpr double unknown_memory = 1024 * mebibyte;
constexpr double unknown_time = 3600;  // [s]

int power_of_two_above(double value) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(std::max(value, 1.0)))));
}

int memory_of(const Job& job) {
  const double expected = job.expected_memory > 0 ? job.expected_memory : unknown_memory;
  return power_of_two_above(memory_margin * expected / mebibyte + 64);
}

// The job keeps its own limit. Slurm's is a minute longer, so that the job can report its time-out.
int minutes_of(const Job& job) {
  const double limit = job.time_limit > 0 ? job.time_limit : unknown_time;
  return power_of_two_above(limit / 60 + 1);
}

}  // namespace

std::vector<SlurmArray> slurm_arrays(const std::vector<Job>& jobs) {
  std::map<std::tuple<bool, int, int, int, std::size_t>, SlurmArray> arrays;
  std::map<std::tuple<bool, int, int, int>, std::size_t> first;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    const auto needs = std::make_tuple(job.alone, job.cores, memory_of(job), minutes_of(job));
    const std::size_t begin = first.try_emplace(needs, i).first->second;
    const auto place = std::tuple_cat(needs, std::make_tuple((i - begin) / places_of_array));
    SlurmArray& array =
        arrays
            .try_emplace(place,
                         SlurmArray{{}, job.cores, memory_of(job), minutes_of(job), job.alone})
            .first->second;
    array.jobs.push_back(i);
  }
  std::vector<SlurmArray> ordered;
  for (auto& [place, array] : arrays) ordered.push_back(std::move(array));
  return ordered;
}

std::vector<std::string> sbatch_arguments(const SlurmArray& array, const std::string& directory,
                                          const std::vector<std::string>& after) {
  std::vector<std::size_t> places;
  for (const std::size_t job : array.jobs) places.push_back(job - array.jobs.front());
  // Of jobs that run alone one is started at a time (%1).
  std::vector<std::string> arguments{
      "--parsable",
      "--job-name=slosh",
      fmt::format("--array={}{}", fmt::join(places, ","), array.alone ? "%1" : ""),
      "--chdir=" + directory,
      "--output=slurm-%A_%a.log",
      fmt::format("--cpus-per-task={}", array.cores),
      fmt::format("--mem={}M", array.memory),
      fmt::format("--time={}", array.minutes)};
  if (array.alone) arguments.push_back("--exclusive");
  if (!after.empty())
    arguments.push_back(fmt::format("--dependency=afterany:{}", fmt::join(after, ":")));
  return arguments;
}

}  // namespace slosh
