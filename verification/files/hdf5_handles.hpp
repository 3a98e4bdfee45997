// HDF5's C handles as RAII values, and the HDF5 calls that the project needs. Each throws Hdf5Error
// with the library's own message in place of a negative status.
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

// While an object of this class exists, HDF5 does not print its error stack.
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

// The access properties of a file in memory. Files are made in memory because HDF5 may crash the
// process on a full disk.
Handle memory_access();
// The bytes of a file in memory whose root group `write` fills.
std::string image_of(const std::function<void(hid_t)>& write);

// Makes a group whose members keep the order of creation, in which member_names() lists them.
Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);
std::vector<std::string> member_names(hid_t group);

void write_attribute(hid_t object, const std::string& name, const std::string& text);  // UTF-8
void write_attribute(hid_t object, const std::string& name, double value);
std::string read_text_attribute(hid_t object, const std::string& name);
double read_number_attribute(hid_t object, const std::string& name);
std::vector<std::string> attribute_names(hid_t object);

// Writes a data set of shape (rows) for one column, or (rows, columns) in row-major order for more;
// each chunk has a Fletcher32 checksum.
Handle write_numbers(hid_t parent, const std::string& name, const std::vector<double>& values,
                     int columns = 1);
std::vector<double> read_numbers(hid_t parent, const std::string& name);
void write_texts(hid_t parent, const std::string& name, const std::vector<std::string>& texts);
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

}  // namespace slosh::hdf5
