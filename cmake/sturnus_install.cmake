# Installs the library so that find_package(sturnus) finds it, and the programs.
include(CMakePackageConfigHelpers)

set(installed sturnus_core)
if(TARGET sturnus)
  list(APPEND installed sturnus)
endif()
install(TARGETS ${installed} EXPORT sturnus_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/sturnus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT sturnus_targets NAMESPACE sturnus:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturnus)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/sturnus-config.cmake.in sturnus-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturnus)
write_basic_package_version_file(sturnus-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/sturnus-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/sturnus-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturnus)
foreach(program sturnus-program sturnus-shadertoy prog06)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()
