# One interface target that every target of the project links privately: language, warnings and
# the floating-point mode that makes results reproducible.
add_library(relievo_options INTERFACE)
target_compile_features(relievo_options INTERFACE cxx_std_20)
target_compile_options(relievo_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                 -Wno-sign-conversion -Werror -ffp-contract=off)
if(RELIEVO_SANITIZE)
  target_compile_options(relievo_options INTERFACE -fsanitize=address,undefined
                                                   -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(relievo_options INTERFACE -fsanitize=address,undefined)
endif()

# relievo_library(name SOURCES... DEPENDS...): a static library below src/.
function(relievo_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                            $<INSTALL_INTERFACE:include/relievo>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS}
                        PRIVATE $<BUILD_INTERFACE:relievo_options> ${ARG_PRIVATE})
endfunction()
