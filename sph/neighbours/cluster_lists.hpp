// Neighbour lists of clusters. A cluster is up to eight consecutive particles of the sorted order;
// its list holds the sources within reach of at least one of them. The pair loop keeps a cluster in
// its lanes and processes one source after another for all eight particles. It needs no gathers or
// scatters, and the order of every particle's sum does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sph/neighbours/cell_grid.hpp"
#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/neighbours/seen_sources.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

// How many sources ahead of its use a pair loop prefetches one, to hide the latency of the memory;
// 32 to 96 were measured to be about equally fast.
inline constexpr std::size_t prefetch_distance = 64;

struct Cluster {
  std::size_t first, size;       // particles [first, first + size)
  const std::uint32_t* sources;  // indices, readable to prefetch_distance past the last
  std::size_t source_count;

  // Returns source number k of the list, and prefetches the one prefetch_distance later.
  const Source& source(const Source* all, std::size_t k) const {
    __builtin_prefetch(&all[sources[k + prefetch_distance]]);
    return all[sources[k]];
  }
};

// Sources in the order of a grid's last sort; the first has the number `first_source` of all
// sources.
struct SortedPoints {
  const CellGrid& grid;
  const Array<float>&x, &z;
  std::size_t first_source;
};

// Consecutive points in the order of a grid.
struct PointRun {
  const float *x, *z;
  std::size_t size;
  std::uint32_t first_source;
};

// Appends the sources of a run that are within reach of one of the points `around` to the list that
// ends at `end`, which must have room for all of them.
struct AppendNear {
  template <Vector Number>
  static void run(const PointRun* points, const PointRun* around, double reach,
                  std::uint32_t** end) {
    std::uint32_t* next = *end;
    for (std::size_t b = 0; b < points->size; b += lanes_of<Number>) {
      const Number x = load<Number>(points->x + b), z = load<Number>(points->z + b);
      Number nearest2 = 2 * reach * reach - Number{};
      for (std::size_t i = 0; i < around->size; ++i) {
        const Number dx = x - static_cast<double>(around->x[i]),
                     dz = z - static_cast<double>(around->z[i]);
        nearest2 = at_most(dx * dx + dz * dz, nearest2);
      }
      const std::size_t count = std::min(lanes_of<Number>, points->size - b);
      for (std::size_t lane = 0; lane < count; ++lane) {
        *next = points->first_source + static_cast<std::uint32_t>(b + lane);
        next += nearest2[lane] < reach * reach;
      }
    }
    *end = next;
  }
};

class ClusterLists {
 public:
  // Cuts particles in the order of the grid's last sort into clusters, each within one row, and
  // lists the points within reach of each cluster. `x` and `z` are the particles' positions in the
  // points' frame. The selection is AllSources or SeenSources.
  template <class Selection = AllSources>
  void build(const CellGrid& grid, const Array<float>& x, const Array<float>& z,
             const std::vector<SortedPoints>& points, double reach,
             const Selection& selection = {}) {
    cut_into_clusters(grid, selection);
    batches_.resize((firsts_.size() - 1 + batch_size - 1) / batch_size);
    const InstructionSet set = widest_instruction_set();
#pragma omp parallel
    {
      std::vector<std::uint32_t> list;
#pragma omp for schedule(dynamic)
      for (std::size_t k = 0; k < batches_.size(); ++k) {
        Batch& batch = batches_[k];
        batch.ends.clear();
        std::size_t length = 0;
        const std::size_t last = std::min((k + 1) * batch_size, firsts_.size() - 1);
        for (std::size_t c = k * batch_size; c < last; ++c) {
          const PointRun cluster{&x[firsts_[c]], &z[firsts_[c]], firsts_[c + 1] - firsts_[c], 0};
          const Rectangle box = box_around(cluster, reach);
          int group = 0;
          if constexpr (Selection::selects) group = selection.group(firsts_[c]);
          for (const SortedPoints& of : points) {
            const std::size_t before = length;
            length = append_sources(of, cluster, box, reach, set, list, length);
            if constexpr (Selection::selects)
              length = select(selection, of, firsts_[c], group, list, before, length);
          }
          batch.ends.push_back(static_cast<std::uint32_t>(length));
        }
        batch.sources.reserve(length + prefetch_distance);
        batch.sources.assign(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(length));
        batch.sources.resize(length + prefetch_distance, 0);
      }
    }
  }

  // Calls visit(cluster) for every cluster, on all threads.
  template <class Visit>
  void for_each(const Visit& visit) const {
#pragma omp parallel for schedule(static)
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      const Batch& list = batches_[batch];
      std::size_t begin = 0;
      for (std::size_t c = 0; c < list.ends.size(); ++c) {
        const std::size_t k = batch * batch_size + c;
        visit(Cluster{firsts_[k], firsts_[k + 1] - firsts_[k], list.sources.data() + begin,
                      list.ends[c] - begin});
        begin = list.ends[c];
      }
    }
  }

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("clusters", firsts_);
    visit("clusters", batches_);
    for (Batch& batch : batches_) {
      visit("clusters", batch.ends);
      visit("lists", batch.sources);
    }
  }

 private:
  static constexpr std::size_t batch_size = 32;
  struct Batch {
    std::vector<std::uint32_t> sources, ends;
  };

  template <class Selection>
  void cut_into_clusters(const CellGrid& grid, const Selection& selection) {
    firsts_.assign(1, 0);
    for (int row = 0; row < grid.rows(); ++row) {
      const IndexRange run = grid.run(row, 0, grid.columns() - 1);
      for (std::size_t end = run.begin; end < run.end;) {
        [[maybe_unused]] const std::size_t first = end;
        end = std::min(end + lane_count, run.end);
        if constexpr (Selection::selects) end = selection.end_of_cluster(first, end);
        firsts_.push_back(static_cast<std::uint32_t>(end));
      }
    }
  }

  static Rectangle box_around(const PointRun& points, double reach) {
    float left = points.x[0], right = left, bottom = points.z[0], top = bottom;
    for (std::size_t i = 1; i < points.size; ++i) {
      left = std::min(left, points.x[i]);
      right = std::max(right, points.x[i]);
      bottom = std::min(bottom, points.z[i]);
      top = std::max(top, points.z[i]);
    }
    return {left - reach, right + reach, bottom - reach, top + reach};
  }

  // Appends the sources of `points` within reach of the cluster and returns the list's new length.
  static std::size_t append_sources(const SortedPoints& points, const PointRun& cluster,
                                    const Rectangle& box, double reach, InstructionSet set,
                                    std::vector<std::uint32_t>& list, std::size_t length) {
    const CellGrid& grid = points.grid;
    const int from = grid.column(box.left), to = grid.column(box.right), upper = grid.row(box.top);
    for (int row = grid.row(box.bottom); row <= upper; ++row) {
      const IndexRange range = grid.run(row, from, to);
      const PointRun run{points.x.data() + range.begin, points.z.data() + range.begin,
                         range.end - range.begin,
                         static_cast<std::uint32_t>(points.first_source + range.begin)};
      if (run.size == 0) continue;
      if (list.size() < length + run.size + 1) list.resize(2 * (length + run.size) + 1);
      std::uint32_t* end = list.data() + length;
      call_in_registers<AppendNear>(set, &run, &cluster, reach, &end);
      length = static_cast<std::size_t>(end - list.data());
    }
    return length;
  }

  // Removes the sources from `begin` to `end` of the list that the selection does not keep for the
  // cluster of the point `first`. Returns the list's new end.
  template <class Selection>
  static std::size_t select(const Selection& selection, const SortedPoints& points,
                            std::size_t first, int group, std::vector<std::uint32_t>& list,
                            std::size_t begin, std::size_t end) {
    const auto at = [&](std::size_t k) { return list.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto kept = std::remove_if(at(begin), at(end), [&](std::uint32_t source) {
      const std::size_t k = source - points.first_source;
      return !selection.keeps(first, group, source, {points.x[k], points.z[k]});
    });
    return static_cast<std::size_t>(kept - list.begin());
  }

  std::vector<std::uint32_t> firsts_;
  std::vector<Batch> batches_;
};

}  // namespace slosh::sph
