# Installs the libraries as the package "relievo": targets relievo::kernel, relievo::relief,
# relievo::io, relievo::render and relievo::solid, their headers below include/relievo, and the program.
include(CMakePackageConfigHelpers)

set(RELIEVO_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/relievo)

install(TARGETS relievo_kernel relievo_relief relievo_io relievo_render relievo_solid
  EXPORT relievo_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS relievo RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/relievo FILES_MATCHING PATTERN "*.h")
install(EXPORT relievo_targets
  NAMESPACE relievo::
  FILE relievo-targets.cmake
  DESTINATION ${RELIEVO_PACKAGE_DIR})

configure_package_config_file(cmake/relievo-config.cmake.in relievo-config.cmake
  INSTALL_DESTINATION ${RELIEVO_PACKAGE_DIR})
write_basic_package_version_file(relievo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/relievo-config.cmake
              ${PROJECT_BINARY_DIR}/relievo-config-version.cmake
        DESTINATION ${RELIEVO_PACKAGE_DIR})
