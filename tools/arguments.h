#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>

#include "io/picture.h"
#include "sculpt/reconstruct.h"

/// The command line of `tetsculpt`.
namespace tetsculpt::cli {

enum class Action { kReconstruct, kHelp, kVersion };

struct Arguments {
  Action action = Action::kReconstruct;
  std::filesystem::path input;
  std::filesystem::path output;
  std::filesystem::path picture;  ///< empty: none
  std::filesystem::path viewer;   ///< empty: none
  View view;
  ReconstructOptions options;
  bool quiet = false;
  bool stats = false;
  bool skip_invalid = false;
};

/// A command line that makes no sense; what() says why.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Parses the words after the program's name. Throws UsageError.
Arguments parse_arguments(std::span<const char* const> words);

/// The text of --help.
std::string help();

/// The names by which options are given and reported.
std::string name(Method method);
std::string name(Criterion criterion);

}  // namespace tetsculpt::cli
