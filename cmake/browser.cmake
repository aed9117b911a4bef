# What the libraries need when they are compiled for the browser, under the names that they have
# natively: headers of Debian's -dev packages, and the C and C++ sources of Debian's source packages
# (scripts/fetch-sources.sh) for what is no header.
set(RELIEVO_SOURCES ${PROJECT_SOURCE_DIR}/build/sources CACHE PATH "What fetch-sources.sh fetched")
if(NOT EXISTS ${RELIEVO_SOURCES}/zlib/zlib.h)
  message(FATAL_ERROR "Run scripts/fetch-sources.sh ${RELIEVO_SOURCES} first")
endif()

# Pages wait for the download. With few functions inlined the code is smaller, and as fast; -Os
# takes twice the time.
set(RELIEVO_FEW_INLINED -mllvm -inline-threshold=25)

# Never all of /usr/include, whose C library is another one.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(folder CGAL boost nlohmann)
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
endforeach()

function(relievo_headers name folder)
  add_library(${name} INTERFACE IMPORTED)
  target_include_directories(${name} SYSTEM INTERFACE ${folder})
endfunction()
relievo_headers(Eigen3::Eigen /usr/include/eigen3)
relievo_headers(nlohmann_json::nlohmann_json ${headers})
relievo_headers(CGAL::CGAL ${headers})
# Only predicates are asked for, and CGAL's own numbers decide them as exactly as GMP's. The
# browser has no other rounding mode than to nearest.
target_compile_definitions(CGAL::CGAL INTERFACE CGAL_DISABLE_GMP CGAL_NO_GMP
                                                CGAL_ALWAYS_ROUND_TO_NEAREST
  # Bounded coordinates give no cause for the errors that Boost would write into streams.
  BOOST_MATH_DOMAIN_ERROR_POLICY=ignore_error BOOST_MATH_POLE_ERROR_POLICY=ignore_error
  BOOST_MATH_OVERFLOW_ERROR_POLICY=ignore_error BOOST_MATH_EVALUATION_ERROR_POLICY=ignore_error
  BOOST_MATH_ROUNDING_ERROR_POLICY=ignore_error)

# relievo_sources(name TARGET FOLDER files...): a library from a source package.
function(relievo_sources name target folder)
  list(TRANSFORM ARGN PREPEND ${folder}/)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} SYSTEM PUBLIC ${folder})
  # Pages wait for the download.
  target_compile_options(${name} PRIVATE -w -Oz)
  add_library(${target} ALIAS ${name})
endfunction()
relievo_sources(zlib ZLIB::ZLIB ${RELIEVO_SOURCES}/zlib
  adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c uncompr.c zutil.c)
relievo_sources(png PNG::PNG ${RELIEVO_SOURCES}/libpng1.6
  png.c pngerror.c pngget.c pngmem.c pngpread.c pngread.c pngrio.c pngrtran.c pngrutil.c pngset.c
  pngtrans.c pngwio.c pngwrite.c pngwtran.c pngwutil.c)
configure_file(${RELIEVO_SOURCES}/libpng1.6/scripts/pnglibconf.h.prebuilt
               ${CMAKE_BINARY_DIR}/png/pnglibconf.h COPYONLY)
target_include_directories(png SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/png)
target_link_libraries(png PUBLIC ZLIB::ZLIB)
relievo_sources(pugixml pugixml::pugixml ${RELIEVO_SOURCES}/pugixml/src pugixml.cpp)
file(CREATE_LINK ${RELIEVO_SOURCES}/libpolyclipping/cpp ${headers}/polyclipping SYMBOLIC)
relievo_sources(polyclipping PkgConfig::POLYCLIPPING ${RELIEVO_SOURCES}/libpolyclipping/cpp
                clipper.cpp)
target_include_directories(polyclipping SYSTEM INTERFACE ${headers})
relievo_sources(meshopt meshoptimizer::meshoptimizer ${RELIEVO_SOURCES}/meshoptimizer/src
                allocator.cpp simplifier.cpp)
