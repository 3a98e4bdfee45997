// Joins the parts of a series that a program wrote in several runs. Private to
// verification/import/.
#pragma once

#include <string>
#include <vector>

namespace slosh {

// Values over increasing times, and where they begin in a file ("force.dat:4").
struct SeriesPart {
  std::vector<double> time, value;
  std::string place;
  std::string at = {};  // the coordinates of the gauge; empty where the file does not give them
};

// One series of several parts. A later part takes the place of all values of the earlier ones from
// its first time on, as the run from which it comes took the place of theirs.
class StitchedSeries {
 public:
  // Throws CaseFileError where the part begins before the first one, as the parts are not in order,
  // and where it is of a gauge at another place.
  void append(const SeriesPart& part);

  std::vector<double> time, value;
  std::vector<std::string> seams;  // one sentence for each part after the first

 private:
  std::string first_place_, at_;  // of the first part
};

}  // namespace slosh
