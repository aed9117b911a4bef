# Installs the package "relievo": the target relievo::relievo with the headers of include/relievo,
# the libraries that it links, and the program.
include(CMakePackageConfigHelpers)

set(RELIEVO_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/relievo)

install(TARGETS relievo_api relievo_kernel relievo_scene relievo_understanding relievo_relief relievo_io relievo_render relievo_solid
  EXPORT relievo_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(TARGETS relievo RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY include/relievo DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(EXPORT relievo_targets
  NAMESPACE relievo::
  FILE relievo-targets.cmake
  DESTINATION ${RELIEVO_PACKAGE_DIR} COMPONENT library)

configure_package_config_file(cmake/relievo-config.cmake.in relievo-config.cmake
  INSTALL_DESTINATION ${RELIEVO_PACKAGE_DIR})
write_basic_package_version_file(relievo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/relievo-config.cmake
              ${PROJECT_BINARY_DIR}/relievo-config-version.cmake
        DESTINATION ${RELIEVO_PACKAGE_DIR} COMPONENT library)
