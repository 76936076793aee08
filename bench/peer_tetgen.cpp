#include "bench/peer_tetgen.h"

#define TETLIBRARY
#include <tetgen.h>

namespace tetsculpt::bench {

std::size_t tetgen_tetrahedra(const std::vector<Point3>& points) {
  tetgenio in, out;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[3 * points.size()];  // tetgenio deletes it
  for (std::size_t k = 0; k < points.size(); ++k) {
    in.pointlist[3 * k] = points[k].x;
    in.pointlist[3 * k + 1] = points[k].y;
    in.pointlist[3 * k + 2] = points[k].z;
  }
  char switches[] = "Q";
  tetrahedralize(switches, &in, &out);
  return static_cast<std::size_t>(out.numberoftetrahedra);
}

}  // namespace tetsculpt::bench
