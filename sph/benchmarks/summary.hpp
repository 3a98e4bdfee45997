// The benchmarks' results as compact tables, printed after Google Benchmark's own output.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace slosh::sph {

class Summary {
 public:
  // Which value of several repetitions is kept.
  enum class Keep { smallest, largest };

  // Tables, rows and columns appear in the order of their first entry.
  void enter(const std::string& table, const std::string& row, const std::string& column,
             double value, Keep keep = Keep::smallest);
  // Prints the tables to standard output.
  void print() const;

 private:
  struct Table {
    std::string title;
    std::vector<std::string> rows, columns;
    std::map<std::pair<std::string, std::string>, double> values;
  };
  static void print(const Table& table);
  std::vector<Table> tables_;
};

}  // namespace slosh::sph
