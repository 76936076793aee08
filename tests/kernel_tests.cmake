add_library(tetsculpt_graph_oracles STATIC support/graph_oracles.cpp)
target_compile_options(tetsculpt_graph_oracles PRIVATE -ffp-contract=off)
target_link_libraries(tetsculpt_graph_oracles PUBLIC tetsculpt_point_sets)

foreach(
  name
  distinct_merge_test
  distinct_range_test
  distinct_invariant_test
  large_array_test
  large_block_test
  parallel_test
  radix_sort_test
  disjoint_sets_test
  simplex_dimension_test
  hilbert_order_test
  insertion_order_test
  hull_shares_test
  hull_structure_test
  hull_convex_test
  delaunay_no_solid_test
  delaunay_oracle_test
  delaunay_empty_sphere_test
  delaunay_fills_hull_test
  delaunay_local_test
  delaunay_input_order_test
  delaunay_progress_test
  delaunay_threads_test
  simplices_test
  complex_turn_test
  complex_incidence_test
  complex_invariant_test
  edge_order_oracle_test
  edge_order_ties_test
  emst_oracle_test
  nng_oracle_test
  gabriel_oracle_test
  egh_oracle_test
  graphs_chain_test
  mesh_topology_test
  mesh_invariant_test)
  tetsculpt_test(${name})
  target_link_libraries(${name} PRIVATE tetsculpt_graph_oracles)
endforeach()
