# Packages for Debian, one a component of what is installed, and what only packages hold: manual
# pages and completions, which the program itself prints, and a changelog and a copyright each.
set(RELIEVO_MAINTAINER "Relievo maintainers <relievo@users.noreply.github.com>"
    CACHE STRING "Who answers for the packages")
set(RELIEVO_PACKAGES_DATE "Thu, 01 Jan 1970 00:00:00 +0000"
    CACHE STRING "The date in the changelogs of packages, as `date -R` writes it")
find_program(RELIEVO_GZIP gzip REQUIRED)

# relievo_printed(file words...): a compressed file of what `relievo manual` prints.
set(printed "")
function(relievo_printed file)
  set(zip "")
  if(file MATCHES "[.]1$")
    set(zip | ${RELIEVO_GZIP} -9n)
    set(file ${file}.gz)
  endif()
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/manual/${file}
    COMMAND relievo manual ${ARGN} ${zip} > ${PROJECT_BINARY_DIR}/manual/${file}
    DEPENDS relievo VERBATIM)
  set(printed ${printed} ${PROJECT_BINARY_DIR}/manual/${file} PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/manual)
relievo_printed(relievo.1 man)
foreach(command IN ITEMS batch build check render segment sequence)
  relievo_printed(relievo-${command}.1 man ${command})
endforeach()
set(pages ${printed})
relievo_printed(relievo bash)
relievo_printed(_relievo zsh)
relievo_printed(relievo.fish fish)
add_custom_target(relievo_manual ALL DEPENDS ${printed})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/relievo
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/_relievo
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/manual/relievo.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

# relievo_package(component name): the Debian package of a component.
set(CPACK_COMPONENTS_ALL "")
function(relievo_package component name section depends summary description)
  string(TOUPPER ${component} key)
  set(folder ${PROJECT_BINARY_DIR}/debian/${name})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/debian/changelog.in ${folder}/changelog.Debian @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/debian/copyright ${folder}/copyright COPYONLY)
  execute_process(COMMAND ${RELIEVO_GZIP} -9nf ${folder}/changelog.Debian)
  install(FILES ${folder}/copyright ${folder}/changelog.Debian.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
endfunction()

set(about "Relievo turns a drawing of a character into a seamless high relief: a model
whose front view is the drawing itself, and whose legs, ears and noses grow
out of the body.")
relievo_package(program relievo graphics "" "turns drawings of characters into reliefs"
  "${about}\nThis package holds the program.")
string(CONCAT libraries "libcgal-dev, libeigen3-dev, libembree-dev, libgif-dev, libheif-dev, "
  "libjpeg-dev, libmeshoptimizer-dev, libpng-dev, libpolyclipping-dev, libpugixml-dev, librsvg2-dev, libwebp-dev, "
  "libzip-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev")
relievo_package(library librelievo-dev libdevel "${libraries}" "reliefs from drawings, the library"
  "${about}\nThis package holds the library, its headers, and what CMake needs to find it.")
find_package(Python3 REQUIRED)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
relievo_package(python python3-relievo python
  "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy"
  "reliefs from drawings, the module for Python" "${about}\nThis package holds the module for Python 3.")
relievo_package(editor relievo-editor web "" "reliefs from drawings, the editor for the browser"
  "${about}\nThis package holds the editor as static files, for any server of web pages.")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/web/ DESTINATION ${CMAKE_INSTALL_DATADIR}/relievo/editor
        COMPONENT editor OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${RELIEVO_MAINTAINER}")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_SOURCE_DIR}/build/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_EDITOR_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
