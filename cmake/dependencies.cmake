# SPDX-License-Identifier: MIT
# Every dependency is a Debian 12 package; the list is in ./bulletnav. Each part looks for what it
# needs; the simulator needs the first block.
find_package(assimp REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(embree 3 REQUIRED)
find_package(fmt REQUIRED)
find_package(JPEG REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(PNG REQUIRED)
find_package(Threads REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(webp REQUIRED IMPORTED_TARGET libwebp)
find_path(RECAST_INCLUDE_DIR recastnavigation/Recast.h REQUIRED)
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)
find_library(RECAST_LIBRARY Recast REQUIRED)
find_library(DETOUR_LIBRARY Detour REQUIRED)

if(BULLETNAV_EGL)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
endif()
if(BULLETNAV_SDF)
  pkg_check_modules(sdformat REQUIRED IMPORTED_TARGET sdformat12)
endif()
if(BULLETNAV_REPORTS)
  pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
  pkg_check_modules(webpmux REQUIRED IMPORTED_TARGET libwebpmux)
endif()
if(BULLETNAV_LEARNING)
  find_package(Torch REQUIRED)
  # Torch has it within, but not its headers.
  find_library(BULLETNAV_GLOO_LIBRARY gloo REQUIRED)
  pkg_check_modules(tcmalloc REQUIRED IMPORTED_TARGET libtcmalloc_minimal)
endif()
if(BULLETNAV_SLAM)
  # Ceres brings ATLAS, which has the same names as the BLAS that the system has chosen, libblas.so.3:
  # the latter comes first, needed or not.
  find_library(BULLETNAV_BLAS_LIBRARY blas REQUIRED)
  find_library(BULLETNAV_CERES_LIBRARY ceres REQUIRED)
  find_library(BULLETNAV_GLOG_LIBRARY glog REQUIRED)
  add_library(bulletnav_ceres INTERFACE)
  target_link_libraries(bulletnav_ceres INTERFACE
    -Wl,--push-state,--no-as-needed ${BULLETNAV_BLAS_LIBRARY} -Wl,--pop-state
    ${BULLETNAV_CERES_LIBRARY} ${BULLETNAV_GLOG_LIBRARY})

  find_package(OpenCV 4 REQUIRED COMPONENTS calib3d core features2d imgproc)
  add_library(bulletnav_opencv INTERFACE)
  target_include_directories(bulletnav_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
  target_link_libraries(bulletnav_opencv INTERFACE opencv_calib3d opencv_core opencv_features2d opencv_imgproc)
endif()
if(BULLETNAV_TOOLS)
  find_package(CLI11 REQUIRED)
endif()
if(BULLETNAV_PYTHON)
  # The interpreter that the module is for. Asked itself, as CMake's own finder keeps the first.
  set(BULLETNAV_PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python to build the module for")
  find_path(BULLETNAV_PYBIND11_INCLUDE pybind11/pybind11.h REQUIRED)
  execute_process(COMMAND ${BULLETNAV_PYTHON_EXECUTABLE} -c
    "import sysconfig as s; print(s.get_path('include'), s.get_config_var('EXT_SUFFIX'), (s.get_config_var('LIBDIR') or '') + '/' + (s.get_config_var('LDLIBRARY') or ''), sep=';')"
    OUTPUT_VARIABLE python_facts OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  list(GET python_facts 0 BULLETNAV_PYTHON_INCLUDE)
  list(GET python_facts 1 BULLETNAV_PYTHON_SUFFIX)
  list(GET python_facts 2 BULLETNAV_LIBPYTHON)
  if(NOT BULLETNAV_LIBPYTHON MATCHES "\\.so")
    set(BULLETNAV_LIBPYTHON "")  # to be taken in whole
  endif()
  if(NOT EXISTS ${BULLETNAV_PYTHON_INCLUDE}/Python.h)
    message(FATAL_ERROR "${BULLETNAV_PYTHON_INCLUDE}/Python.h is missing: install the headers of "
      "${BULLETNAV_PYTHON_EXECUTABLE} (Debian's python3-dev)")
  endif()
endif()
if(BULLETNAV_TESTS)
  find_package(benchmark REQUIRED)
  find_package(GTest REQUIRED)
endif()
