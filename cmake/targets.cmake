# tetsculpt_library(NAME SOURCES... DEPENDS...): one static library per folder, all with the same rules.
# The arithmetic flags are private: exactness rests on them in our sources, a consumer gets none of ours.
function(tetsculpt_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(tetsculpt_${name} STATIC ${arg_SOURCES})
  add_library(tetsculpt::${name} ALIAS tetsculpt_${name})
  set_target_properties(tetsculpt_${name} PROPERTIES EXPORT_NAME ${name}
                                                     POSITION_INDEPENDENT_CODE ON)
  target_compile_features(tetsculpt_${name} PUBLIC cxx_std_20)
  # Two scalars put together by a vectorizer that are stored as one and loaded apart, or the other way round,
  # wait for each other: GCC's costs the hull a seventh of its time.
  target_compile_options(tetsculpt_${name} PRIVATE -ffp-contract=off -fno-tree-slp-vectorize)
  target_include_directories(
    tetsculpt_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tetsculpt>)
  if(arg_DEPENDS)
    target_link_libraries(tetsculpt_${name} PUBLIC ${arg_DEPENDS})
  endif()
endfunction()
