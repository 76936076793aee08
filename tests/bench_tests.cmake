# What the benchmarks print and draw; Google Benchmark is not needed.
include(${PROJECT_SOURCE_DIR}/bench/report.cmake)

foreach(name bench_fit_test bench_svg_plot_test)
  tetsculpt_test(${name})
  target_link_libraries(${name} PRIVATE tetsculpt_bench_report)
endforeach()
