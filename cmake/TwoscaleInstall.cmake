# SPDX-License-Identifier: GPL-3.0-or-later
# Install and export. One export set a room, so that find_package(twoscale COMPONENTS kernels) asks for no computer algebra.
include(CMakePackageConfigHelpers)

set(TWOSCALE_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/twoscale")
get_property(_rooms GLOBAL PROPERTY TWOSCALE_ROOMS)
foreach(_room IN LISTS _rooms)
  install(TARGETS twoscale_${_room} EXPORT twoscale-${_room})
  install(EXPORT twoscale-${_room} NAMESPACE twoscale:: DESTINATION "${TWOSCALE_PACKAGE_DIR}"
    FILE twoscale-${_room}.cmake)
  get_target_property(_root twoscale_${_room} TWOSCALE_ROOM_ROOT)
  if(IS_DIRECTORY "${_root}/include")
    install(DIRECTORY "${_root}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
  endif()
endforeach()

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/twoscale-config.cmake.in" "${PROJECT_BINARY_DIR}/twoscale-config.cmake"
  INSTALL_DESTINATION "${TWOSCALE_PACKAGE_DIR}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/twoscale-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/twoscale-config.cmake" "${PROJECT_BINARY_DIR}/twoscale-config-version.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/FindGiNaC.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindFlintArb.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/FindGLPK.cmake"
  DESTINATION "${TWOSCALE_PACKAGE_DIR}")
install(FILES "${PROJECT_SOURCE_DIR}/COPYING" "${PROJECT_SOURCE_DIR}/LICENSES/0BSD.txt" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
