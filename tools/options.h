#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/arguments.h"

/// The options of the command, each told once: the parser, --help, the manual and the completion
/// are drawn from this table.
namespace tetsculpt::cli {

enum class OptionGroup { kInput, kOutput, kMethod, kMore, kReport, kProgram, kHidden };

/// Groups in the order of the help, with their titles; kHidden has none.
struct GroupTitle {
  OptionGroup group;
  std::string_view title;
};
inline constexpr std::array<GroupTitle, 6> kGroupTitles{{
    {OptionGroup::kInput, "Input"},
    {OptionGroup::kOutput, "Output"},
    {OptionGroup::kMethod, "Method"},
    {OptionGroup::kMore, "More to write"},
    {OptionGroup::kReport, "Messages"},
    {OptionGroup::kProgram, "Program"},
}};

enum class Takes {
  kNothing,
  kValue,          ///< --name VALUE, --name=VALUE
  kOptionalValue,  ///< --name, --name=VALUE
};

struct Option {
  OptionGroup group;
  char letter;  ///< 0: none
  std::string_view name;
  Takes takes;
  std::string_view value;  ///< what its value is called: FILE and PREFIX are files
  std::string_view help;
  /// Notes it. The value is empty if there is none. May throw UsageError.
  void (*note)(Arguments& arguments, std::string_view value);
  /// The values it may have; null: any.
  std::vector<std::string> (*values)() = nullptr;
};

std::span<const Option> options();

/// The names by which options are given and reported.
std::string name(Method method);
std::string name(Criterion criterion);

/// The words of a list with one blank between them.
std::vector<std::string> split_words(std::string_view list);

}  // namespace tetsculpt::cli
