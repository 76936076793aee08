#pragma once

#include <filesystem>
#include <span>
#include <string_view>

/// The words behind `check` and `info`: one file, and few options.
namespace tetsculpt::cli {

struct FileWords {
  std::filesystem::path file;
  std::filesystem::path points;  ///< of --points; empty: none
  bool json = false;             ///< --json, or --stats
  bool weld = false;             ///< --weld
  bool help = false;             ///< --help: nothing else counts
};

struct FileWordsRules {
  std::string_view noun;      ///< what the file is, for messages
  bool mesh_options = false;  ///< --points and --weld are options
};

/// Throws UsageError.
FileWords parse_file_words(std::span<const char* const> words, const FileWordsRules& rules);

}  // namespace tetsculpt::cli
