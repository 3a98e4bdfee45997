// The list of the arrays that a run holds in memory for its particles, with their purposes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "sph/run_output.hpp"

namespace slosh::sph {

class HeldArrays {
 public:
  // Adds the memory of an array to the entry of that purpose and name; an array without memory is
  // not entered.
  template <class Array>
  void add(const std::string& purpose, const std::string& name, const Array& array) {
    const std::size_t bytes = array.capacity() * sizeof(array[0]);
    if (bytes == 0) return;
    const auto same = std::find_if(held_.begin(), held_.end(), [&](const HeldArray& held) {
      return held.purpose == purpose && held.name == name;
    });
    if (same == held_.end())
      held_.push_back({purpose, name, bytes});
    else
      same->bytes += bytes;
  }

  // Adds every array that the owner's for_each_named_field visits.
  template <class Owner>
  void add_all(const std::string& purpose, Owner& owner) {
    owner.for_each_named_field(
        [&](const char* name, const auto& array) { add(purpose, name, array); });
  }

  const std::vector<HeldArray>& held() const { return held_; }

 private:
  std::vector<HeldArray> held_;
};

}  // namespace slosh::sph
