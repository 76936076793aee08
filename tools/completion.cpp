#include <string>
#include <string_view>
#include <vector>

#include "tools/help.h"
#include "tools/options.h"

namespace tetsculpt::cli {
namespace {

/// "-o|--output": how a case names an option that takes a value.
std::string pattern(const Option& option) {
  std::string text = option.letter != 0 ? std::string("-") + option.letter + "|" : "";
  return text.append("--").append(option.name);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// What may follow each option that takes a value.
std::string value_cases() {
  std::string cases;
  for (const Option& option : options()) {
    if (option.takes == Takes::kNothing || option.group == OptionGroup::kHidden) continue;
    cases += "    " + pattern(option) + ") ";
    if (option.values != nullptr) {
      cases += "values='" + joined(option.values()) + "' ;;\n";
    } else {
      cases += option.value == "FILE" || option.value == "PREFIX" ? "files=1 ;;\n" : ": ;;\n";
    }
  }
  return cases;
}

std::string option_words() {
  std::vector<std::string> words;
  for (const Option& option : options()) {
    if (option.group == OptionGroup::kHidden) continue;
    if (option.letter != 0) words.push_back({'-', option.letter});
    words.push_back("--" + std::string(option.name));
  }
  return joined(words);
}

/// The options whose value may not follow as a word of its own.
std::string attached_only() {
  std::vector<std::string> words;
  for (const Option& option : options()) {
    if (option.takes == Takes::kOptionalValue) words.push_back("--" + std::string(option.name));
  }
  return joined(words);
}

}  // namespace

std::string bash_completion() {
  // Readline breaks words at "=": --method=pa comes as three words.
  return R"(# Completion of tetsculpt for bash 4 and later.
_tetsculpt() {
  local current=${COMP_WORDS[COMP_CWORD]} option= values= files=
  if [[ $current == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-1]} current=
  elif (( COMP_CWORD > 2 )) && [[ ${COMP_WORDS[COMP_CWORD-1]} == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-2]}
  elif (( COMP_CWORD > 1 )) && [[ " )" +
         attached_only() + R"( " != *" ${COMP_WORDS[COMP_CWORD-1]} "* ]]; then
    option=${COMP_WORDS[COMP_CWORD-1]}
  fi
  case $option in
)" + value_cases() +
         R"(    *)
      if [[ $current == -* ]]; then
        values=')" +
         option_words() + R"('
      else
        files=1
        (( COMP_CWORD == 1 )) && values='check info'
      fi ;;
  esac
  COMPREPLY=()
  if [[ $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
  fi
  if [[ $files ]]; then
    compopt -o filenames 2> /dev/null
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$current")
  fi
}
complete -F _tetsculpt tetsculpt
)";
}

}  // namespace tetsculpt::cli
