#include "tools/arguments.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "io/extension.h"
#include "tools/options.h"
#include "tools/suggestion.h"

namespace tetsculpt::cli {
namespace {

/// The names with something before each, joined; "a, b or c" if the last is to stand out.
std::string joined(const std::vector<std::string>& words, std::string_view last = ", ") {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += k + 1 == words.size() ? last : std::string_view(", ");
    text += words[k];
  }
  return text;
}

const Option* option_named(std::string_view name) {
  for (const Option& option : options()) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

const Option* option_lettered(char letter) {
  for (const Option& option : options()) {
    if (option.letter != 0 && option.letter == letter) return &option;
  }
  return nullptr;
}

/// `word` as it was given; `name` without its dashes.
[[noreturn]] void unknown_option(std::string_view word, std::string_view name) {
  std::vector<std::string> names;
  for (const Option& option : options()) {
    if (option.group != OptionGroup::kHidden) names.push_back("--" + std::string(option.name));
  }
  throw UsageError("unknown option '" + std::string(word) + "'" +
                   did_you_mean("--" + std::string(name), names));
}

/// One pass over the words.
class Parser {
 public:
  explicit Parser(std::span<const char* const> words) : words_(words) {}

  Arguments run() {
    out_.options.threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
    bool options_ended = false;
    while (next_ < words_.size() && out_.action == Action::kReconstruct) {
      const std::string_view word = words_[next_++];
      if (options_ended || word.size() < 2 || word[0] != '-') {
        files_.push_back(word);
      } else if (word == "--") {
        options_ended = true;
      } else if (word[1] == '-') {
        take_long(word);
      } else {
        take_letters(word);
      }
    }
    if (out_.action == Action::kReconstruct) {
      place_files();
      out_.options.keep = {.graphs = !out_.graphs.empty() || !out_.viewer.empty(),
                           .tetrahedra = !out_.tetrahedra.empty(),
                           .record = !out_.viewer.empty()};
    }
    return std::move(out_);
  }

 private:
  /// --name, --name=value, --name value.
  void take_long(std::string_view word) {
    const std::string_view given = word.substr(0, word.find('='));
    const Option* option = option_named(given.substr(2));
    if (option == nullptr) unknown_option(given, given.substr(2));
    const bool attached = given.size() < word.size();
    if (option->takes == Takes::kNothing && attached) {
      throw UsageError(std::string(given) + " takes no value");
    }
    if (attached) {
      const std::string_view value = word.substr(given.size() + 1);
      if (option->takes == Takes::kOptionalValue && value.empty()) {
        throw UsageError(std::string(given) + "= needs a file");
      }
      note(*option, given, value);
    } else {
      note(*option, given, option->takes == Takes::kValue ? next_word(given) : "");
    }
  }

  /// -q, -qv, -o value, -ovalue.
  void take_letters(std::string_view word) {
    const std::string_view before_value = word.substr(0, word.find('='));
    if (option_named(before_value.substr(1)) != nullptr) {  // -output
      unknown_option(before_value, before_value.substr(1));
    }
    for (std::size_t k = 1; k < word.size(); ++k) {
      const Option* option = option_lettered(word[k]);
      if (option == nullptr) unknown_option(before_value, before_value.substr(1));
      const std::string given{'-', word[k]};
      if (option->takes == Takes::kValue) {
        return note(*option, given, k + 1 < word.size() ? word.substr(k + 1) : next_word(given));
      }
      note(*option, given, "");
    }
  }

  std::string_view next_word(std::string_view given) {
    if (next_ == words_.size()) throw UsageError(std::string(given) + " needs a value");
    return words_[next_++];
  }

  void note(const Option& option, std::string_view given, std::string_view value) {
    if (option.values != nullptr) {
      const std::vector<std::string> known = option.values();
      if (std::ranges::find(known, value) == known.end()) {
        throw UsageError(std::string(given) + ": '" + std::string(value) + "' is none of " +
                         joined(known) + did_you_mean(value, known));
      }
    }
    option.note(out_, value);
  }

  /// Words without dashes are the input and the output, where no option gave them.
  void place_files() {
    for (const std::string_view file : files_) {
      if (out_.input.empty()) {
        out_.input = file;
      } else if (out_.output.empty()) {
        out_.output = file;
      } else {
        throw UsageError("unexpected word '" + std::string(file) + "'");
      }
    }
  }

  std::span<const char* const> words_;
  std::size_t next_ = 0;
  std::vector<std::string_view> files_;
  Arguments out_;
};

/// Throws UsageError unless the file's extension is one of these.
void check_extension(const std::filesystem::path& file, std::string_view kind,
                     const std::vector<std::string>& known) {
  const std::string extension = lowercase_extension(file);
  if (std::ranges::find(known, extension) != known.end()) return;
  throw UsageError(file.string() + ": unknown kind of " + std::string(kind) + "; use " +
                   joined(known, " or ") +
                   (extension.empty() ? "" : did_you_mean(extension, known)));
}

void check_output(const Arguments& a) {
  if (a.writes_standard_output()) {
    if (!a.output_format) throw UsageError("standard output needs --output-format");
    if (a.stats && a.stats_file.empty()) {
      throw UsageError("standard output takes the surface or the statistics; use --stats=FILE");
    }
  } else if (!a.output_format) {
    check_extension(a.output, "output file", split_words(mesh_format_extensions()));
  }
  if (a.ply_encoding == PlyEncoding::kAscii &&
      a.output_format.value_or(mesh_format_of(a.output).value_or(MeshFormat::kPly)) !=
          MeshFormat::kPly) {
    throw UsageError("--ascii is for .ply files; " + a.output.string() + " is none");
  }
  if (!a.picture.empty()) check_extension(a.picture, "picture", {".png"});
  if (!a.viewer.empty()) check_extension(a.viewer, "viewer", {".html"});
  if (!a.tetrahedra.empty()) check_extension(a.tetrahedra, "tetrahedra file", {".vtk", ".mesh"});
}

void check(const Arguments& a) {
  if (a.input.empty()) throw UsageError("no input file given");
  if (a.output.empty() && !a.dry_run) throw UsageError("no output file given");
  if (a.picture.empty() && a.viewer.empty() && a.view_given) {
    throw UsageError("--view and --up need --picture or --viewer");
  }
  if (a.quiet && (a.verbose || a.progress)) {
    throw UsageError("--quiet and " + std::string(a.verbose ? "--verbose" : "--progress") +
                     " contradict each other");
  }
  if (a.dry_run && a.stats) throw UsageError("--stats with --dry-run, which computes nothing");
  if (!a.output.empty()) check_output(a);
}

}  // namespace

Arguments parse_arguments(std::span<const char* const> words) {
  Arguments arguments = Parser(words).run();
  if (arguments.action == Action::kReconstruct) check(arguments);
  return arguments;
}

}  // namespace tetsculpt::cli
