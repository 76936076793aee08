#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "io/picture.h"

/// Pictures in a folder, with their captions in a list.
namespace tetsculpt::bench {

class Album {
 public:
  /// Makes the folder if need be, and begins the list `album.tsv` in it. Throws std::runtime_error
  /// (a filesystem_error among others) if that fails.
  explicit Album(const std::filesystem::path& folder);

  /// Draws NAME.png and adds a line to the list: figure, file, caption. Throws IoError.
  void add(const std::string& figure, const std::string& name, const Scene& scene, const View& view,
           const std::string& caption);
  /// Adds a line without a picture: figure, empty, text.
  void note(const std::string& figure, const std::string& text);

 private:
  std::filesystem::path folder_;
  std::ofstream list_;
};

}  // namespace tetsculpt::bench
