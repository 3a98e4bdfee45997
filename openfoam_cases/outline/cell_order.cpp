#include "openfoam_cases/outline/cell_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace slosh::openfoam {
namespace {

void share_columns(std::vector<CellToOrder>& cells, int processes) {
  std::map<int, int> counts;  // by column
  for (const CellToOrder& cell : cells) ++counts[cell.place.column];
  std::map<int, int> process_of;
  double before = 0;
  for (const auto& [column, count] : counts) {
    const double middle = (before + count / 2.0) / static_cast<double>(cells.size());
    process_of[column] = std::min(static_cast<int>(middle * processes), processes - 1);
    before += count;
  }
  for (CellToOrder& cell : cells) cell.process = process_of[cell.place.column];
}

// Returns the same cells with oblique ones at even places.
std::vector<int> interleaved(const std::vector<int>& sorted, const std::vector<CellToOrder>& cells,
                             int process) {
  std::vector<int> oblique, level;
  for (const int cell : sorted) (cells[cell].is_oblique ? oblique : level).push_back(cell);
  // A last cell that is not one of a pair is safe too, but is treated as the others.
  if (level.empty() || oblique.size() > level.size())
    throw std::invalid_argument(fmt::format(
        "OpenFOAM tank: cells_x and cells_z: {} of the {} cells of process {} lie at an oblique "
        "part of the outline: expected smaller cells or fewer processes, so that at most half do",
        oblique.size(), sorted.size(), process));
  const auto rank = [&](int cell) {
    return std::pair(cells[cell].place.row, cells[cell].place.column);
  };
  std::vector<int> order;
  std::size_t next_oblique = 0, next_level = 0;
  while (order.size() < sorted.size()) {
    const std::size_t left_oblique = oblique.size() - next_oblique,
                      left_level = level.size() - next_level;
    const bool may_be_oblique = order.size() % 2 == 0 && left_oblique > 0;
    const bool is_first =
        left_level == 0 || left_oblique >= left_level ||
        (left_oblique > 0 && rank(oblique[next_oblique]) < rank(level[next_level]));
    order.push_back(may_be_oblique && is_first ? oblique[next_oblique++] : level[next_level++]);
  }
  return order;
}

}  // namespace

std::vector<int> order_cells(std::vector<CellToOrder>& cells, int processes) {
  share_columns(cells, processes);
  std::vector<std::vector<int>> of_process(processes);
  for (std::size_t i = 0; i < cells.size(); ++i)
    of_process[cells[i].process].push_back(static_cast<int>(i));
  std::vector<int> order;
  for (int process = 0; process < processes; ++process) {
    std::vector<int>& own = of_process[process];
    std::sort(own.begin(), own.end(), [&](int a, int b) {
      return std::pair(cells[a].place.row, cells[a].place.column) <
             std::pair(cells[b].place.row, cells[b].place.column);
    });
    const std::vector<int> part = interleaved(own, cells, process);
    order.insert(order.end(), part.begin(), part.end());
  }
  return order;
}

}  // namespace slosh::openfoam
