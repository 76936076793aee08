add_library(tetsculpt_exact_predicates STATIC support/exact_predicates.cpp)
target_link_libraries(tetsculpt_exact_predicates PUBLIC tetsculpt_kernel)

foreach(
  name
  predicates_exact_integer_test
  predicates_convention_test
  predicates_orient3d_test
  predicates_insphere_test
  predicates_diametral_sphere_test
  predicates_equatorial_sphere_test
  predicates_barycentric_sign_test
  predicates_compare_lengths_test
  predicates_collinear_test
  predicates_integer_stage_test
  double_double_test
  predicates_symmetry_test
  hull_bucket_test
  hull_centers_test
  hull_cone_lanes_test
  hull_cone_test
  hull_facets_height_test
  hull_four_lanes_test
  hull_helper_test
  hull_lanes_test
  hull_range_test
  hull_region_test
  hull_room_test
  hull_sites_test
  hull_sphere_test
  hull_spokes_test
  perturbation_sphere_test
  perturbation_diametral_sphere_test
  perturbation_equatorial_sphere_test
  perturbation_exchange_test
  perturbation_lattice_delaunay_test)
  tetsculpt_test(${name})
  target_link_libraries(${name} PRIVATE tetsculpt_exact_predicates)
endforeach()
