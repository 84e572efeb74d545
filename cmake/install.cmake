# SPDX-License-Identifier: MIT
# `cmake --install` puts the simulator where find_package(bulletnav) finds it: target
# bulletnav::sim, its parts, and bulletnav-import, which reads scenes for it: component
# `development`.
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
install(TARGETS ${installed} EXPORT bulletnav ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT development)
set(importers bulletnav-import)
if(BULLETNAV_SDF)
  list(APPEND importers bulletnav-import-sdf)
endif()
install(TARGETS ${importers} RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bulletnav
  COMPONENT development)
install(EXPORT bulletnav NAMESPACE bulletnav:: FILE bulletnav-targets.cmake
  DESTINATION ${package_dir} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/sim
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bulletnav COMPONENT development FILES_MATCHING PATTERN *.h
  PATTERN grid EXCLUDE PATTERN import EXCLUDE)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/bulletnav-config.cmake.in
  ${PROJECT_BINARY_DIR}/bulletnav-config.cmake INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bulletnav-config-version.cmake
  COMPATIBILITY ExactVersion)
install(FILES ${PROJECT_BINARY_DIR}/bulletnav-config.cmake
  ${PROJECT_BINARY_DIR}/bulletnav-config-version.cmake DESTINATION ${package_dir}
  COMPONENT development)

# Component `program`: the program with the libraries it loads, beside each other, and what it reads
# when it runs. cmake/make_deb.sh packs it.
if(BULLETNAV_TOOLS)
  set(program_dir lib/bulletnav)
  install(TARGETS bulletnav ${importers} RUNTIME DESTINATION ${program_dir} COMPONENT program)
  foreach(library bulletnav_learning bulletnav_slam bulletnav_python_agent)
    if(TARGET ${library})
      install(TARGETS ${library} LIBRARY DESTINATION ${program_dir} COMPONENT program)
    endif()
  endforeach()
  set(link ${PROJECT_BINARY_DIR}/installed/bulletnav)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/installed)
  file(CREATE_LINK ../${program_dir}/bulletnav ${link} SYMBOLIC)
  install(FILES ${link} DESTINATION bin COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/weights DESTINATION share/bulletnav/assets
    COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs DESTINATION share/bulletnav COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/doc/bulletnav/docs
    COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/results/reference
    DESTINATION share/doc/bulletnav/results COMPONENT program
    FILES_MATCHING PATTERN *.md PATTERN *.svg PATTERN summary.json PATTERN drives EXCLUDE)
  install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
    ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION share/doc/bulletnav COMPONENT program)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/bulletnav RENAME copyright
    COMPONENT program)
endif()
