# The layers, and that the check of them can fail.
add_test(NAME check_layers COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P
                                   ${CMAKE_CURRENT_SOURCE_DIR}/check_layers.cmake)
add_test(NAME check_layers_test
         COMMAND ${CMAKE_COMMAND} -DCHECK=${CMAKE_CURRENT_SOURCE_DIR}/check_layers.cmake
                 -DWORK=${CMAKE_CURRENT_BINARY_DIR}/planted_tree -P
                 ${CMAKE_CURRENT_SOURCE_DIR}/check_layers_test.cmake)

if(TARGET tetsculpt_cli)
  add_library(tetsculpt_cli_support STATIC support/sculpt_child.cpp support/sculpt_cli.cpp)
  target_link_libraries(tetsculpt_cli_support PUBLIC tetsculpt_io tetsculpt_sculpt_support)
  target_compile_definitions(
    tetsculpt_cli_support PUBLIC TETSCULPT_CLI="$<TARGET_FILE:tetsculpt_cli>"
                                 TETSCULPT_VERSION="${PROJECT_VERSION}")
  add_dependencies(tetsculpt_cli_support tetsculpt_cli)
  foreach(
    name
    cli_attributes_test
    cli_completion_test
    cli_dry_run_test
    cli_exit_status_test
    cli_graphs_test
    cli_interrupt_test
    cli_manual_test
    cli_normals_test
    cli_options_test
    cli_output_files_test
    cli_picture_test
    cli_progress_test
    cli_scan_test
    cli_stats_file_test
    cli_stats_test
    cli_usage_test
    cli_vertex_attributes_test
    cli_viewer_test)
    tetsculpt_test(${name})
    target_link_libraries(${name} PRIVATE tetsculpt_cli_support)
  endforeach()

  target_sources(cli_vertex_attributes_test PRIVATE ${PROJECT_SOURCE_DIR}/tools/surface_file.cpp)

  # In a real browser; skipped where there is none.
  find_package(Python3 COMPONENTS Interpreter)
  if(Python3_FOUND)
    add_test(NAME viewer_page_test
             COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/viewer_page_test.py
                     $<TARGET_FILE:tetsculpt_cli> ${CMAKE_CURRENT_SOURCE_DIR}/data/kitten.xyz)
    set_tests_properties(viewer_page_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900)
  endif()

  # With our flags, so that a build with sanitizers links. The install rules take the program along.
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  add_test(NAME consumer_test
           COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR}
                   -DSOURCE=${CMAKE_CURRENT_SOURCE_DIR}/consumer
                   -DWORK=${CMAKE_CURRENT_BINARY_DIR}/consumer -DGENERATOR=${CMAKE_GENERATOR}
                   -DCOMPILER=${CMAKE_CXX_COMPILER}
                   "-DFLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" -P
                   ${CMAKE_CURRENT_SOURCE_DIR}/consumer_test.cmake)
endif()
