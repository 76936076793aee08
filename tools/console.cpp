#include "tools/console.h"

#include <cstdio>

namespace tetsculpt::cli {

int fail(ExitStatus status, const std::string& message) {
  std::fprintf(stderr, "tetsculpt: %s\n", message.c_str());
  return status;
}

int print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return kDone;
  return fail(kNoOutput, "standard output could not be written");
}

std::string counted(std::size_t n, std::string_view noun) {
  std::string text = std::to_string(n) + ' ';
  if (n != 1 && noun == "vertex") return text + "vertices";
  return text.append(noun).append(n == 1 ? "" : "s");
}

}  // namespace tetsculpt::cli
