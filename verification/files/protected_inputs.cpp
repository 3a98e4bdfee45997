#include "verification/files/protected_inputs.hpp"

#include <algorithm>
#include <mutex>
#include <set>
#include <system_error>

namespace slosh {
namespace {

namespace fs = std::filesystem;

// By their paths without links. The files are compared anew at each output, because an editor may
// have put another file under the same name.
class ProtectedInputs {
 public:
  void add(const fs::path& file) {
    std::error_code absent;
    const fs::path place = fs::canonical(file, absent);
    const std::lock_guard lock(mutex_);
    if (!absent) places_.insert(place);
  }
  std::set<fs::path> all() const {
    const std::lock_guard lock(mutex_);
    return places_;
  }

 private:
  mutable std::mutex mutex_;
  std::set<fs::path> places_;
};

ProtectedInputs& protected_inputs() {
  static ProtectedInputs files;
  return files;
}

}  // namespace

bool lies_below(const fs::path& file, const fs::path& directory) {
  return std::mismatch(directory.begin(), directory.end(), file.begin(), file.end()).first ==
         directory.end();
}

void protect_input(const fs::path& file) { protected_inputs().add(file); }

void require_no_input(const fs::path& output) {
  if (output.filename() == ".slosh")
    throw OutputError(output.string() +
                      ": expected another name for an output, as Slosh keeps its list of what it "
                      "has made in a directory there");
  std::error_code absent;
  const fs::path place = fs::canonical(output, absent);
  if (absent) return;
  for (const fs::path& input : protected_inputs().all())
    if (fs::equivalent(input, place, absent) || lies_below(input, place))
      throw OutputError(output.string() + ": expected another place for an output, as " +
                        (input == place ? "it" : input.string() + ", which lies there,") +
                        " is an input of this command and would be lost");
}

}  // namespace slosh
