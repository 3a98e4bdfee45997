#include "reports/model/base64.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace slosh::reports {

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  // Three bytes make four characters; what the last three lack is marked by '='.
  const std::size_t lacking = (3 - bytes.size() % 3) % 3;
  const std::string whole = bytes + std::string(lacking, '\0');
  std::string text(Base64(whole.begin()), Base64(whole.end()));
  return text.replace(text.size() - lacking, lacking, lacking, '=');
}

}  // namespace slosh::reports
