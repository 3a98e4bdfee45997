// The solver's speed, from whole steps down to single loops, compared with the machine's peak. The
// sums are checked before anything is timed (answer_check.hpp), and the state after each timing.
// `--benchmark_filter=REGEX` selects benchmarks; the summary holds those selected.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "sph/benchmarks/answer_check.hpp"
#include "sph/benchmarks/machine_ceilings.hpp"
#include "sph/benchmarks/pair_loops.hpp"
#include "sph/benchmarks/stepping.hpp"
#include "sph/benchmarks/summary.hpp"
#include "sph/counts/counted_memory.hpp"
#include "sph/schemes.hpp"

namespace slosh::sph {
namespace {

Summary summary;
bool failed = false;

void fail(benchmark::State& state, const std::exception& error) {
  failed = true;
  state.SkipWithError(error.what());
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Returns the processor time for one thread, which a busy machine disturbs less, and the wall time
// for more threads.
double seconds_of(int threads) {
  if (threads > 1) return wall_seconds();
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Size {
  const char* name;
  int rows;   // twice the square is the number of particles
  int steps;  // timed together; enough to renew the lists of a calm liquid at least once
};
constexpr Size sizes[] = {{"20k", 100, 48}, {"100k", 224, 48}, {"500k", 500, 24}};

struct TimedMethod {
  const char* name;
  std::unique_ptr<Stepping> (*make)(int rows, Flow flow);
};

template <class Choice>
std::unique_ptr<Stepping> make_stepping(int rows, Flow flow) {
  return std::make_unique<SteppingOf<Choice>>(benchmark_scene(rows, {}), flow);
}

// Sets h / dp = sqrt(neighbours / pi) / 2, at which the support holds that many particles.
template <class Choice, int neighbours>
std::unique_ptr<Stepping> make_with_neighbours(int rows, Flow flow) {
  const double ratio = std::sqrt(neighbours / std::numbers::pi) / kernel_support;
  return std::make_unique<SteppingOf<Choice>>(benchmark_scene(rows, ratio), flow);
}

constexpr TimedMethod methods[] = {
    {"wendland_20", make_with_neighbours<WithWendlandC2, 20>},
    {"wendland_48", make_with_neighbours<WithWendlandC2, 48>},
    {"recommended", make_stepping<Recommended>},
    {"li2010", make_stepping<Li2010>},
    {"delta_sph", make_stepping<DeltaSph>},
};

const char* name_of(Flow flow) { return flow == Flow::calm ? "calm" : "violent"; }

struct StepTiming {
  double nanoseconds;      // per particle and step
  double neighbour_share;  // share of neighbour search, sorting and lists
  double rebuilds;         // per step
};

StepTiming time_steps(Stepping& stepping, int steps, int threads) {
  const double neighbours_before = stepping.neighbour_seconds;
  const long rebuilds_before = stepping.rebuilds;
  const double wall_start = wall_seconds(), start = seconds_of(threads);
  for (int i = 0; i < steps; ++i) stepping.step();
  const double seconds = seconds_of(threads) - start, wall = wall_seconds() - wall_start;
  const double n = static_cast<double>(stepping.particles());
  return {1e9 * seconds / (n * steps), (stepping.neighbour_seconds - neighbours_before) / wall,
          static_cast<double>(stepping.rebuilds - rebuilds_before) / steps};
}

void whole_step(benchmark::State& state, const TimedMethod& method, Flow flow, const Size& size,
                int threads) try {
  omp_set_num_threads(threads);
  const auto stepping = method.make(size.rows, flow);
  for (int i = 0; i < 4; ++i) stepping->step();
  const std::string row = fmt::format("{} {}", method.name, name_of(flow));
  const std::string column = threads == 1 ? size.name : fmt::format("{} x{}", size.name, threads);
  for (auto _ : state) {
    const StepTiming t = time_steps(*stepping, size.steps, threads);
    state.SetIterationTime(t.nanoseconds * 1e-9 * static_cast<double>(stepping->particles()) *
                           size.steps);
    state.counters["ns/particle"] = t.nanoseconds;
    state.counters["search"] = t.neighbour_share;
    state.counters["rebuilds/step"] = t.rebuilds;
    summary.enter("Whole step [ns per particle and step]", row, column, t.nanoseconds);
    if (threads == 1 && size.rows == sizes[1].rows) {
      summary.enter("Search, sort and lists at 100k", row, "share of the time", t.neighbour_share);
      summary.enter("Search, sort and lists at 100k", row, "times per step", t.rebuilds);
    }
  }
  omp_set_num_threads(1);
  stepping->check();
} catch (const std::exception& error) {
  fail(state, error);
}

void memory(benchmark::State& state, const TimedMethod& method) {
  const std::size_t before = counted_memory().now;
  const auto stepping = method.make(sizes[2].rows, Flow::calm);
  restart_peak();
  for (auto _ : state) stepping->step();
  const double n = static_cast<double>(stepping->particles());
  const double held = static_cast<double>(counted_memory().now - before) / n,
               peak = static_cast<double>(counted_memory().peak - before) / n;
  state.counters["byte/particle"] = held;
  state.counters["peak"] = peak;
  summary.enter("Memory at 500k [byte per particle]", method.name, "held", held);
  summary.enter("Memory at 500k [byte per particle]", method.name, "at most", peak);
}

const char* name_of(Loop which) {
  switch (which) {
    case Loop::momentum:
      return "momentum";
    case Loop::continuity:
      return "continuity";
    case Loop::refresh:
      return "refresh of sources";
    case Loop::rebuild:
      return "sort and lists";
  }
  return "";
}

// Times one loop on one thread.
void loop(benchmark::State& state, Loop which, InstructionSet set, const Size& size) try {
  PairLoops loops(size.rows, std::sqrt(20 / std::numbers::pi) / kernel_support);
  for (auto _ : state) {
    constexpr int rounds = 4;
    loops.run(which, set);
    const double start = seconds_of(1);
    for (int round = 0; round < rounds; ++round) loops.run(which, set);
    const double seconds = (seconds_of(1) - start) / rounds;
    state.SetIterationTime(seconds);
    summary.enter("One loop, Wendland C2 at 20 neighbours, disordered [ns per particle]",
                  fmt::format("{}, {}", name_of(which), instruction_set_name(set)), size.name,
                  1e9 * seconds / static_cast<double>(loops.particles()));
    if (set != widest_instruction_set() || flops_of_pair(which) == 0) continue;
    const auto enter = [&](const char* column, double value) {
      summary.enter("Pair loops, to be held against the machine",
                    fmt::format("{}, {}", name_of(which), size.name), column, value,
                    Summary::Keep::largest);
    };
    enter("Gpair/s", 1e-9 * loops.evaluated_pairs() / seconds);
    enter("of use", 1e-9 * loops.useful_pairs() / seconds);
    enter("GFLOP/s", 1e-9 * flops_of_pair(which) * loops.evaluated_pairs() / seconds);
    enter("GB/s", 1e-9 * bytes_of_source * loops.listed_sources() / seconds);
  }
} catch (const std::exception& error) {
  fail(state, error);
}

void flops(benchmark::State& state) {
  for (auto _ : state) {
    const double value = 1e-9 * peak_flops(widest_instruction_set());
    state.SetIterationTime(1);
    state.counters["GFLOP/s"] = value;
    summary.enter("The machine, one core", "multiply and add", "GFLOP/s", value,
                  Summary::Keep::largest);
  }
}

void bandwidth(benchmark::State& state, const char* level, std::size_t bytes) {
  for (auto _ : state) {
    const double value = 1e-9 * read_bandwidth(bytes, widest_instruction_set());
    state.SetIterationTime(1);
    state.counters["GB/s"] = value;
    summary.enter("The machine, one core", level, "GB/s read", value, Summary::Keep::largest);
  }
}

template <class... Arguments>
void add(const std::string& name, int repetitions, const Arguments&... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), arguments...)
      ->Iterations(repetitions)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void add_all() {
  add("machine/flops", 1, flops);
  constexpr std::size_t kib = 1024;
  for (const auto& [level, bytes] : {std::pair{"L1, 24 KiB", 24 * kib},
                                     {"L2, 384 KiB", 384 * kib},
                                     {"L3, 6 MiB", 6 * kib * kib},
                                     {"memory, 512 MiB", 512 * kib * kib}})
    add(fmt::format("machine/read/{}", level), 1, bandwidth, level, bytes);
  for (const Loop which : {Loop::momentum, Loop::continuity, Loop::refresh, Loop::rebuild})
    for (const Size& size : sizes)
      for (const InstructionSet set : instruction_sets)
        if (has(set) && (set == widest_instruction_set() || (&size == &sizes[0])))
          add(fmt::format("loop/{}/{}/{}", name_of(which), instruction_set_name(set), size.name), 3,
              loop, which, set, size);
  for (const TimedMethod& method : methods)
    for (const Flow flow : {Flow::calm, Flow::violent})
      for (const int threads : {1, 2})
        for (const Size& size : sizes) {
          if (threads > 1 && &size != &sizes[1]) continue;
          add(fmt::format("step/{}/{}/{}/{}", method.name, name_of(flow), size.name, threads), 2,
              whole_step, method, flow, size, threads);
        }
  for (const TimedMethod& method : methods)
    add(fmt::format("memory/{}", method.name), 1, memory, method);
}

}  // namespace
}  // namespace slosh::sph

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  omp_set_num_threads(1);
  try {
    slosh::sph::check_pair_sums();
  } catch (const std::exception& error) {
    fmt::print(stderr, "the answer is wrong, nothing is timed: {}\n", error.what());
    return 1;
  }
  slosh::sph::add_all();
  benchmark::RunSpecifiedBenchmarks();
  slosh::sph::summary.print();
  return slosh::sph::failed ? 1 : 0;
}
