# A plain `cmake -B build` optimises, since Eigen and CGAL are many times slower without.
get_property(relievo_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(PROJECT_IS_TOP_LEVEL AND NOT relievo_multi_config AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

# One interface target that every target of the project links privately: language, warnings and
# the floating-point mode that makes results reproducible.
add_library(relievo_options INTERFACE)
target_compile_features(relievo_options INTERFACE cxx_std_20)
target_compile_options(relievo_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                 -Wno-sign-conversion -Werror -ffp-contract=off
                                                 # GCC 12 misjudges "literal" + std::string at -O3.
                                                 $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict>)
# Sums in one order everywhere, so that the browser computes what this program does.
target_compile_definitions(relievo_options INTERFACE EIGEN_DONT_VECTORIZE)
if(EMSCRIPTEN)
  # What libraries throw is caught in C++; no exception leaves the module.
  add_compile_options(-fwasm-exceptions)
  add_link_options(-fwasm-exceptions)
endif()
if(RELIEVO_SANITIZE)
  target_compile_options(relievo_options INTERFACE -fsanitize=address,undefined
                                                   -fno-sanitize-recover=all -fno-omit-frame-pointer
                                                   # The address sanitizer sees what these would,
                                                   # and they take half of the compiler's time.
                                                   -fno-sanitize=null,alignment,object-size,vptr
                                                   -fno-sanitize=nonnull-attribute,returns-nonnull-attribute
                                                   # GCC sees uninitialised reads in instrumented code.
                                                   $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(relievo_options INTERFACE -fsanitize=address,undefined)
endif()

if(RELIEVO_PYTHON)
  # The module is a shared object that shows nothing of the libraries in it.
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(CMAKE_CXX_VISIBILITY_PRESET hidden)
  set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
endif()

if(PROJECT_IS_TOP_LEVEL)
  find_program(RELIEVO_CCACHE ccache)
  if(RELIEVO_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${RELIEVO_CCACHE})
  endif()
  find_program(RELIEVO_LLD ld.lld)
  if(RELIEVO_LLD AND NOT EMSCRIPTEN)
    target_link_options(relievo_options INTERFACE -fuse-ld=lld)
  endif()
endif()

# relievo_unite(target): compiles the files of each folder together. Most of a file's time goes into
# headers of libraries, which is then spent once; but a change to one file compiles all of them.
function(relievo_unite target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "files_of_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# relievo_library(name SOURCES... DEPENDS...): a static library below src/,
# which the installed relievo::relievo links.
function(relievo_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  string(REPLACE "relievo_" "" short_name ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short_name})
  add_library(relievo::${short_name} ALIAS ${name})
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS}
                        PRIVATE $<BUILD_INTERFACE:relievo_options> ${ARG_PRIVATE})
  if(RELIEVO_UNITE)
    # At the end of the folder, when all files are known.
    cmake_language(EVAL CODE "cmake_language(DEFER CALL relievo_unite ${name})")
  endif()
endfunction()
