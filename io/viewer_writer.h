#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/picture.h"
#include "kernel/point.h"
#include "kernel/sculpting_record.h"

/// A surface and how it came about, as one HTML file that any browser shows without a network.
namespace tetsculpt {

/// What the page shows. The spans and the record must outlive the writing.
struct ViewerScene {
  std::string title = {};                                       ///< any text, as are the facts
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< name and value, a line each
  /// Vertices are numbered through the points, then the hidden ones.
  std::span<const Point3> points = {};
  std::span<const Point3> hidden = {};
  const SculptingRecord* record = nullptr;  ///< its last step is the surface
  std::span<const std::array<std::uint32_t, 2>> emst_edges = {};
  std::span<const std::array<std::uint32_t, 3>> egh_triangles = {};
};

struct ViewerOptions {
  View view = {};  ///< from where it is seen at first; the size is the window's
  /// The record is coarsened (kernel/sculpting_record.h) until at most so many triangles come and
  /// go before the surface is there: about 13 bytes each in the file, 20 in the browser.
  std::size_t most_passing_triangles = 8'000'000;
};

/// Writes the page. The file appears whole or not at all, see io/atomic_file.h. Positions are
/// rounded to floats after they were centred and scaled in doubles.
/// Precondition: coordinates are finite, and the indices are of vertices.
/// Throws IoError on a failing disk.
void write_viewer(const ViewerScene& scene, const std::filesystem::path& path,
                  const ViewerOptions& options = {});

}  // namespace tetsculpt
