#include "bench/peers.h"

#ifdef TETSCULPT_PEER_CGAL
#include "bench/peer_cgal.h"
#endif
#ifdef TETSCULPT_PEER_TETGEN
#include "bench/peer_tetgen.h"
#endif
#ifdef TETSCULPT_PEER_QHULL
#include "bench/peer_qhull.h"
#endif
#ifdef TETSCULPT_PEER_HXT
#include "bench/peer_hxt.h"
#endif

namespace tetsculpt::bench {

std::vector<Peer> peers() {
  std::vector<Peer> found;
#ifdef TETSCULPT_PEER_CGAL
  found.push_back({"CGAL", cgal_tetrahedra, 2'000'000});
#endif
#ifdef TETSCULPT_PEER_HXT
  found.push_back({"HXT", hxt_tetrahedra, 2'000'000});
#endif
#ifdef TETSCULPT_PEER_TETGEN
  found.push_back({"TetGen", tetgen_tetrahedra, 200'000});
#endif
#ifdef TETSCULPT_PEER_QHULL
  found.push_back({"Qhull", qhull_tetrahedra, 70'000});
#endif
  return found;
}

}  // namespace tetsculpt::bench
