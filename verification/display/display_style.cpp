#include "verification/display/display_style.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace slosh {

DisplayStyle style_of(int descriptor) {
  constexpr int usual_columns = 80;  // where the terminal reports none
  const auto variable = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string_view(text ? text : "");
  };
  const bool live = isatty(descriptor) && variable("TERM") != "dumb";
  winsize size{};
  const bool has_size = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return {.live = live,
          .colour = live && variable("NO_COLOR").empty(),
          .columns = has_size ? size.ws_col : usual_columns};
}

}  // namespace slosh
