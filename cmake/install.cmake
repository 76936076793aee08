# Installs the library, its headers under include/tetsculpt, and the files find_package(tetsculpt) reads.
include(CMakePackageConfigHelpers)

install(TARGETS tetsculpt tetsculpt_kernel tetsculpt_sculpt tetsculpt_io
        EXPORT tetsculpt_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(folder kernel sculpt io)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tetsculpt
          FILES_MATCHING PATTERN "*.h")
endforeach()
if(TETSCULPT_TOOLS)
  install(TARGETS tetsculpt_cli DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(NOT CMAKE_CROSSCOMPILING)
    install(FILES ${PROJECT_BINARY_DIR}/tetsculpt.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${PROJECT_BINARY_DIR}/tetsculpt.bash
            DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
            RENAME tetsculpt)
  endif()
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tetsculpt)
install(EXPORT tetsculpt_targets NAMESPACE tetsculpt:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/tetsculpt-config.cmake.in
                              ${PROJECT_BINARY_DIR}/tetsculpt-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tetsculpt-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tetsculpt-config.cmake
              ${PROJECT_BINARY_DIR}/tetsculpt-config-version.cmake
        DESTINATION ${package_dir})
