# Guided sculpting: its parts, and surfaces from end to end.
foreach(
  name
  circumspheres_oracle_test
  deform_complete_test
  deform_expose_test
  deform_rules_test
  deform_topology_test
  first_guess_test
  flip_walk_test
  guided_bodies_test
  guided_nested_test
  guided_noise_test
  guided_order_test
  guided_property_test
  label_graph_test
  min_cut_oracle_test
  poles_oracle_test
  poles_surface_test
  star_faults_test
  star_fill_test
  star_inspector_test
  star_manifold_test
  star_search_test)
  tetsculpt_test(${name})
  target_link_libraries(${name} PRIVATE tetsculpt_sculpt_support)
endforeach()
