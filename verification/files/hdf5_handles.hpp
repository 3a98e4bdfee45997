// HDF5's C handles as values that close themselves, and the few calls that this folder makes of
// them. Each throws Hdf5Error with the library's own words in place of a negative status.
#pragma once

#include <hdf5.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace slosh::hdf5 {

struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns the status or handle unless it is negative.
hid_t checked(hid_t status, const std::string& action);

class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& action)
      : id_(checked(id, action)), close_(close) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

// While one lives, HDF5 does not print its error stack.
class QuietErrors {
 public:
  QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
  ~QuietErrors();

 private:
  H5E_auto2_t print_;
  void* print_data_;
};

// Properties of a file that lives in memory alone, and the bytes of one whose root `write` fills.
// On a full disk HDF5 may crash the process; nothing of it writes to the disk where that can be
// helped.
Handle memory_access();
std::string image_of(const std::function<void(hid_t)>& write);

Handle create_group(hid_t parent,
                    const std::string& name);  // its members keep the order of creation
Handle open_group(hid_t parent, const std::string& name);
std::vector<std::string> member_names(hid_t group);  // in the order of creation

void write_attribute(hid_t object, const std::string& name, const std::string& text);  // UTF-8
void write_attribute(hid_t object, const std::string& name, double value);
std::string read_text_attribute(hid_t object, const std::string& name);
double read_number_attribute(hid_t object, const std::string& name);
std::vector<std::string> attribute_names(hid_t object);

// Shape (rows) or, above one column, (rows, columns) in row-major order; each chunk carries a
// Fletcher32 sum.
Handle write_numbers(hid_t parent, const std::string& name, const std::vector<double>& values,
                     int columns = 1);
std::vector<double> read_numbers(hid_t parent, const std::string& name);
void write_texts(hid_t parent, const std::string& name, const std::vector<std::string>& texts);
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

}  // namespace slosh::hdf5
