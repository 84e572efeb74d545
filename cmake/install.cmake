# SPDX-License-Identifier: MIT
# `cmake --install` puts the simulator where find_package(bulletnav) finds it: target
# bulletnav::sim, its parts, and bulletnav-import, which reads scenes for it.
include(CMakePackageConfigHelpers)

set(installed bulletnav_options)
foreach(name base config image math navmesh noise physics render_projection render
             scene_mesh scene sensors_core sensors_noise sensors_types sensors threads)
  list(APPEND installed bulletnav_sim_${name})
endforeach()
list(APPEND installed bulletnav_sim)
if(BULLETNAV_HOUSES)
  list(APPEND installed bulletnav_sim_config_json bulletnav_sim_house)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bulletnav)
install(TARGETS ${installed} EXPORT bulletnav ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS bulletnav-import RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bulletnav)
install(EXPORT bulletnav NAMESPACE bulletnav:: FILE bulletnav-targets.cmake
  DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/sim
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bulletnav FILES_MATCHING PATTERN *.h
  PATTERN grid EXCLUDE PATTERN import EXCLUDE)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/bulletnav-config.cmake.in
  ${PROJECT_BINARY_DIR}/bulletnav-config.cmake INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bulletnav-config-version.cmake
  COMPATIBILITY ExactVersion)
install(FILES ${PROJECT_BINARY_DIR}/bulletnav-config.cmake
  ${PROJECT_BINARY_DIR}/bulletnav-config-version.cmake DESTINATION ${package_dir})
