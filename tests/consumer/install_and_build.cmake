# Installs the build in BUILD_DIR below WORK_DIR, then builds and runs programs of SOURCE_DIR against
# nothing but the installed package.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
endfunction()

function(build_against_package name folder)
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/${folder} -B ${WORK_DIR}/${name} -G ${GENERATOR}
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/${name})
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
build_against_package(consumer tests/consumer)
run(${WORK_DIR}/consumer/consumer ${SOURCE_DIR}/examples)
build_against_package(embed examples/embed)
# The program and the example finish models alike, of parts that hide others and of inked rims alone.
foreach(drawing examples/wolf tests/data/inked_circle)
  foreach(ending glb stl)
    set(input ${SOURCE_DIR}/${drawing}.svg)
    run(${WORK_DIR}/embed/embed ${input} ${WORK_DIR}/embedded.${ending})
    run(${WORK_DIR}/prefix/bin/relievo build ${input} -q -o ${WORK_DIR}/built.${ending})
    run(${CMAKE_COMMAND} -E compare_files ${WORK_DIR}/embedded.${ending} ${WORK_DIR}/built.${ending})
  endforeach()
endforeach()
