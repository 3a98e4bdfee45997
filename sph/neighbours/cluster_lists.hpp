// Neighbour lists of clusters: up to eight particles that stand together in the sorted order, and
// the sources within reach of the box around them. The pair loop keeps a cluster in its lanes and
// takes one source after another for all eight: no gathers, no scatters, and every particle sums in
// a fixed order whatever the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sph/neighbours/cell_grid.hpp"
#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

struct Cluster {
  std::size_t first, size;       // particles [first, first + size)
  const std::uint32_t* sources;  // indices
  std::size_t source_count;
};

class ClusterLists {
 public:
  // Clusters of the particles whose cells, ascending, are `particle_cells`; no cluster reaches
  // across rows. `x`, `z`: the particles' positions in the sources' frame. `sources` are in the
  // order of the grid's last sort.
  void build(const CellGrid& grid, const std::vector<std::uint32_t>& particle_cells,
             const Array<double>& x, const Array<double>& z, const Array<Source>& sources,
             double reach) {
    cut_into_clusters(grid, particle_cells);
    batches_.resize((firsts_.size() - 1 + batch_size - 1) / batch_size);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      Batch& list = batches_[batch];
      list.sources.clear();
      list.ends.clear();
      const std::size_t last = std::min((batch + 1) * batch_size, firsts_.size() - 1);
      for (std::size_t c = batch * batch_size; c < last; ++c) {
        append_sources(grid, x, z, firsts_[c], firsts_[c + 1], sources, reach, list.sources);
        list.ends.push_back(static_cast<std::uint32_t>(list.sources.size()));
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

 private:
  static constexpr std::size_t batch_size = 32;
  struct Batch {
    std::vector<std::uint32_t> sources, ends;
  };

  void cut_into_clusters(const CellGrid& grid, const std::vector<std::uint32_t>& cells) {
    firsts_.assign(1, 0);
    const auto row_of = [&](std::size_t i) { return cells[i] / grid.columns(); };
    std::size_t first = 0;
    for (std::size_t i = 1; i <= cells.size(); ++i)
      if (i == cells.size() || i - first == lane_count || row_of(i) != row_of(first)) {
        firsts_.push_back(static_cast<std::uint32_t>(i));
        first = i;
      }
  }

  static void append_sources(const CellGrid& grid, const Array<double>& x, const Array<double>& z,
                             std::size_t first, std::size_t end, const Array<Source>& sources,
                             double reach, std::vector<std::uint32_t>& list) {
    const auto [left, right] = std::minmax_element(&x[first], &x[end - 1] + 1);
    const auto [bottom, top] = std::minmax_element(&z[first], &z[end - 1] + 1);
    const int from = grid.column(*left - reach), to = grid.column(*right + reach);
    for (int row = grid.row(*bottom - reach); row <= grid.row(*top + reach); ++row) {
      const IndexRange run = grid.run(row, from, to);
      for (std::size_t b = run.begin; b < run.end; ++b) {
        const double dx = std::max({*left - sources[b].x, sources[b].x - *right, 0.0});
        const double dz = std::max({*bottom - sources[b].z, sources[b].z - *top, 0.0});
        if (dx * dx + dz * dz < reach * reach) list.push_back(static_cast<std::uint32_t>(b));
      }
    }
  }

  std::vector<std::uint32_t> firsts_;
  std::vector<Batch> batches_;
};

}  // namespace slosh::sph
