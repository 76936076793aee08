#include "tools/file_words.h"

#include <string>
#include <vector>

#include "tools/arguments.h"
#include "tools/suggestion.h"

namespace tetsculpt::cli {
namespace {

class Parser {
 public:
  Parser(std::span<const char* const> words, const FileWordsRules& rules)
      : words_(words), rules_(rules) {}

  FileWords run() && {
    bool options_ended = false;
    while (next_ < words_.size()) {
      const std::string_view word = words_[next_++];
      if (!options_ended && word == "--") {
        options_ended = true;
      } else if (!options_ended && word.size() > 1 && word.starts_with('-')) {
        take_option(word);
        if (out_.help) return out_;
      } else {
        if (!out_.file.empty()) throw UsageError("more than one file: " + std::string(word));
        out_.file = word;
      }
    }
    if (out_.file.empty()) throw UsageError("no " + std::string(rules_.noun) + " file given");
    return out_;
  }

 private:
  void take_option(std::string_view option) {
    constexpr std::string_view kPoints = "--points";
    if (option == "-h" || option == "--help") {
      out_.help = true;
    } else if (option == "--json" || option == "--stats") {
      out_.json = true;
    } else if (rules_.mesh_options && option == "--weld") {
      out_.weld = true;
    } else if (rules_.mesh_options && option == kPoints) {
      take_points(next_ < words_.size() ? words_[next_++] : "");
    } else if (rules_.mesh_options && option.starts_with("--points=")) {
      take_points(option.substr(kPoints.size() + 1));
    } else {
      std::vector<std::string> known = {"--json", "--help"};
      if (rules_.mesh_options) known.insert(known.end(), {"--points", "--weld"});
      throw UsageError("unknown option '" + std::string(option) + "'" +
                       did_you_mean(option, known));
    }
  }

  void take_points(std::string_view file) {
    if (file.empty()) throw UsageError("--points needs a file");
    out_.points = file;
  }

  std::span<const char* const> words_;
  const FileWordsRules& rules_;
  std::size_t next_ = 0;
  FileWords out_;
};

}  // namespace

FileWords parse_file_words(std::span<const char* const> words, const FileWordsRules& rules) {
  return Parser(words, rules).run();
}

}  // namespace tetsculpt::cli
