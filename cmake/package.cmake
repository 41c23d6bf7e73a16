# What `cmake --install` gives: the package proofreel, with proofreel::golden and its headers.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/proofreel)
configure_file(cmake/proofreelConfig.cmake.in ${PROJECT_BINARY_DIR}/proofreelConfig.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/proofreelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
set_target_properties(golden_pictures PROPERTIES EXPORT_NAME golden OUTPUT_NAME proofreel_golden)
set_target_properties(picture_files PROPERTIES OUTPUT_NAME proofreel_picture_files)
set_target_properties(hashes PROPERTIES OUTPUT_NAME proofreel_hashes)
install(TARGETS golden_pictures picture_files hashes EXPORT proofreelTargets)
install(EXPORT proofreelTargets NAMESPACE proofreel:: DESTINATION ${package_folder})
install(DIRECTORY golden/include/proofreel DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_BINARY_DIR}/proofreelConfig.cmake ${PROJECT_BINARY_DIR}/proofreelConfigVersion.cmake
  DESTINATION ${package_folder})
