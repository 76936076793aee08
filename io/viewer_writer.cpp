// The page holds its arrays as base64, each in a script element of a type that browsers do not run:
// positions as little-endian floats; integers as differences from the one before, modulo 2^32, the
// signed d >= 0 as 2 d and others as -2 d - 1, in groups of seven bits, lowest first, with the
// eighth bit set on all but the last of a number. io/viewer/data.js reads them.
#include "io/viewer_writer.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

#include "io/atomic_file.h"
#include "io/base64.h"
#include "io/byte_order.h"
#include "io/camera.h"
#include "io/viewer_page.h"

namespace tetsculpt {
namespace {

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

/// One array of the page: takes bytes, writes their text.
class ArrayElement {
 public:
  ArrayElement(AtomicFile& out, std::string_view id) : out_(out) {
    out_.write("<script type=\"text/plain\" id=\"" + std::string(id) + "-data\">");
  }
  void add(float value) {
    std::array<char, 4> bytes;
    store_little_endian(bytes.data(), value);
    for (const char byte : bytes) add_byte(byte);
  }
  void add(std::uint32_t value) {
    const std::uint32_t difference = value - std::exchange(last_, value);
    std::uint32_t rest = difference << 1 ^ (difference >> 31 != 0 ? 0xffffffffu : 0u);
    for (; rest >= 0x80; rest >>= 7) add_byte(static_cast<char>((rest & 0x7f) | 0x80));
    add_byte(static_cast<char>(rest));
  }
  void finish() {
    flush();
    out_.write("</script>\n");
  }

 private:
  void add_byte(char byte) {
    bytes_[end_++] = byte;
    if (end_ == bytes_.size()) flush();
  }
  void flush() {
    out_.write(base64({bytes_.data(), end_}));
    end_ = 0;
  }

  AtomicFile& out_;
  std::array<char, 3 * 4096> bytes_;  // a multiple of three: texts of blocks can be joined
  std::size_t end_ = 0;
  std::uint32_t last_ = 0;
};

template <std::size_t N>
void write_simplices(AtomicFile& out, std::string_view id,
                     std::span<const std::array<std::uint32_t, N>> simplices) {
  ArrayElement element(out, id);
  for (const auto& simplex : simplices) {
    for (const std::uint32_t v : simplex) element.add(v);
  }
  element.finish();
}

void write_numbers(AtomicFile& out, std::string_view id, std::span<const std::uint32_t> numbers) {
  ArrayElement element(out, id);
  for (const std::uint32_t n : numbers) element.add(n);
  element.finish();
}

/// Turned to the first view, within the unit ball.
void write_positions(AtomicFile& out, const ViewerScene& scene, const View& view) {
  Box box = box_of(scene.points);
  box.include_all(box_of(scene.hidden));
  ArrayElement element(out, "positions");
  if (!box.empty) {
    const Turn turn(box, view);
    for (const auto& points : {scene.points, scene.hidden}) {
      for (const Point3& p : points) {
        const Vec3<double> v = turn(p);
        for (const double x : {v.x, v.y, v.z}) element.add(static_cast<float>(x));
      }
    }
  }
  element.finish();
}

void write_data(AtomicFile& out, const ViewerScene& scene, const ViewerOptions& options) {
  const auto lasting = std::ranges::count(scene.record->died, SculptingRecord::kNever);
  const SculptingRecord record =
      coarsened(*scene.record, static_cast<std::size_t>(lasting) + options.most_passing_triangles);
  out.write("<script type=\"application/json\" id=\"sizes\">{\"steps\": " +
            std::to_string(record.step_count) +
            ", \"hidden\": " + std::to_string(scene.hidden.size()) + "}</script>\n");
  write_positions(out, scene, options.view);
  write_simplices<3>(out, "triangles", record.triangles);
  write_numbers(out, "born", record.born);
  write_numbers(out, "died", record.died);
  write_simplices<2>(out, "emst", scene.emst_edges);
  write_simplices<3>(out, "egh", scene.egh_triangles);
}

std::string fact_rows(const ViewerScene& scene) {
  std::string rows;
  for (const auto& [name, value] : scene.facts) {
    rows += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  }
  return rows;
}

}  // namespace

void write_viewer(const ViewerScene& scene, const std::filesystem::path& path,
                  const ViewerOptions& options) {
  assert(scene.record != nullptr);
  AtomicFile out(path);
  std::string_view page = kViewerPage;
  for (std::size_t open = page.find("{{"); open != page.npos; open = page.find("{{")) {
    const std::size_t close = page.find("}}", open);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    out.write(page.substr(0, open));
    if (name == "title") out.write(escaped(scene.title));
    if (name == "facts") out.write(fact_rows(scene));
    if (name == "data") write_data(out, scene, options);
    page.remove_prefix(close + 2);
  }
  out.write(page);
  out.commit();
}

}  // namespace tetsculpt
