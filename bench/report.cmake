# Fits and plots, which need no Google Benchmark: the tests link them, too.
include_guard(GLOBAL)

add_library(tetsculpt_bench_report STATIC ${PROJECT_SOURCE_DIR}/bench/fit.cpp
                                          ${PROJECT_SOURCE_DIR}/bench/svg_plot.cpp)
target_compile_features(tetsculpt_bench_report PUBLIC cxx_std_20)
target_include_directories(tetsculpt_bench_report PUBLIC ${PROJECT_SOURCE_DIR})
