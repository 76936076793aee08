// The command line program: parses, and calls what was asked for.
#include <array>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/arguments.h"
#include "tools/check.h"
#include "tools/help.h"
#include "tools/info.h"
#include "tools/interrupt.h"
#include "tools/messages.h"
#include "tools/run.h"
#include "tools/suggestion.h"
#include "tools/version.h"
#include "tools/viewer.h"

namespace tetsculpt::cli {
namespace {

/// What to say of a first word that names no file and is nearly one of an action; empty: nothing.
std::string mistyped_action(std::string_view first) {
  std::error_code ignored;
  if (first.find_first_of("-./\\") != std::string_view::npos) return "";
  if (std::filesystem::exists(first, ignored)) return "";
  const std::string hint = did_you_mean(first, std::array<std::string, 2>{"check", "info"});
  return hint.empty() ? "" : "there is no file '" + std::string(first) + "'" + hint;
}

int run_words(std::span<const char* const> words) {
  const std::string_view first = words.empty() ? "" : words.front();
  if (first == "check") return check(words.subspan(1));
  if (first == "info") return info(words.subspan(1));
  const std::string mistyped = mistyped_action(first);
  Arguments arguments;
  try {
    arguments = parse_arguments(words);
    if (!mistyped.empty() && arguments.input == first) throw UsageError(mistyped);
  } catch (const UsageError& error) {
    return fail(kUsage, (mistyped.empty() ? error.what() : mistyped) +
                            std::string(" ('tetsculpt --help' explains)"));
  }
  switch (arguments.action) {
    case Action::kHelp:
      return print(help());
    case Action::kVersion:
      return print(std::string("tetsculpt ") + kVersion + '\n');
    case Action::kManual:
      return print(manual());
    case Action::kCompletion:
      return print(bash_completion());
    case Action::kReconstruct:
      break;
  }
  return run(arguments);
}

}  // namespace
}  // namespace tetsculpt::cli

int main(int argc, char** argv) {
  tetsculpt::cli::leave_nothing_when_interrupted();
  try {
    return tetsculpt::cli::run_words({argv + 1, static_cast<std::size_t>(argc - 1)});
  } catch (const std::bad_alloc&) {
    return tetsculpt::cli::fail(tetsculpt::cli::kBadInput, "out of memory for this many points");
  }
}
