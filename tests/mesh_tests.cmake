foreach(
  name
  io_broken_gltf_test
  io_broken_meshes_test
  io_gltf_mesh_test
  io_json_value_test
  io_mesh_dialects_test
  io_mesh_fuzz_test
  io_mesh_round_trip_test
  io_mesh_vtk_test
  mesh_points_test
  mesh_report_faults_test
  mesh_shape_test
  nearest_distances_oracle_test)
  tetsculpt_test(${name})
endforeach()

if(TARGET tetsculpt_cli)
  foreach(name cli_check_points_test cli_check_test cli_info_test)
    tetsculpt_test(${name})
    target_link_libraries(${name} PRIVATE tetsculpt_cli_support)
  endforeach()
endif()
