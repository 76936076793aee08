#include "bench/album.h"

#include <stdexcept>

#include "io/png_writer.h"

namespace tetsculpt::bench {

Album::Album(const std::filesystem::path& folder) : folder_(folder) {
  std::filesystem::create_directories(folder);
  list_.open(folder / "album.tsv");
  if (!list_) throw std::runtime_error((folder / "album.tsv").string() + ": cannot be written");
}

void Album::add(const std::string& figure, const std::string& name, const Scene& scene,
                const View& view, const std::string& caption) {
  View sized = view;
  sized.width = 480;
  sized.height = 400;
  write_png(draw(scene, sized), folder_ / (name + ".png"));
  list_ << figure << '\t' << name << ".png\t" << caption << '\n';
}

void Album::note(const std::string& figure, const std::string& text) {
  list_ << figure << "\t\t" << text << '\n';
}

}  // namespace tetsculpt::bench
