#include "tools/messages.h"

#include <array>
#include <cstdio>

namespace tetsculpt::cli {
namespace {

constexpr std::array<StatusMeaning, 9> kMeanings{{
    {0, "done"},
    {1, "wrong usage"},
    {2, "bad input: unreadable, broken, or with an invalid point"},
    {3, "the points span no solid: fewer than 4, all on a line, or all in a plane"},
    {4, "done, but the points named on stderr could not be brought to the surface"},
    {5, "the output could not be written"},
    {6, "check: the mesh was read, and has faults"},
    {130, "stopped by Ctrl-C (SIGINT): no file is left half written"},
    {143, "stopped by SIGTERM, likewise"},
}};

}  // namespace

std::span<const StatusMeaning> status_meanings() { return kMeanings; }

int fail(ExitStatus status, const std::string& message) {
  std::fprintf(stderr, "tetsculpt: %s\n", message.c_str());
  return status;
}

int print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return kDone;
  return fail(kNoOutput, "standard output could not be written");
}

std::string counted(std::size_t n, std::string_view noun) {
  if (n != 1 && noun == "tetrahedron") noun = "tetrahedra";
  if (n != 1 && noun == "vertex") noun = "vertices";
  const bool plain = n == 1 || noun == "tetrahedra" || noun == "vertices";
  return std::to_string(n) + ' ' + std::string(noun) + (plain ? "" : "s");
}

}  // namespace tetsculpt::cli
