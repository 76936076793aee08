# Stages before sculpting, and an independent replay of it.
add_library(tetsculpt_sculpt_support STATIC
            support/sculpt_prisms.cpp support/sculpt_replay.cpp support/sculpt_rules.cpp
            support/sculpt_stages.cpp)
target_link_libraries(tetsculpt_sculpt_support PUBLIC tetsculpt_sculpt tetsculpt_point_sets)

foreach(
  name
  boundary_counts_test
  manifold_solid_test
  paper_bodies_test
  paper_euler_relation_test
  paper_lifting_test
  paper_order_test
  paper_rules_test
  paper_work_test
  priority_numbering_test
  priority_definition_test
  removal_queue_test
  prism_brute_force_test
  reconstruct_cancel_test
  reconstruct_input_points_test
  reconstruct_kept_test
  reconstruct_order_test
  reconstruct_progress_test
  reconstruct_small_sets_test
  reconstruct_span_test
  reconstruct_story_test
  record_coarsened_test
  record_replay_test)
  tetsculpt_test(${name})
  target_link_libraries(${name} PRIVATE tetsculpt_sculpt_support)
endforeach()
