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
run(${WORK_DIR}/embed/embed ${SOURCE_DIR}/examples/wolf.svg ${WORK_DIR}/embedded.glb)
run(${WORK_DIR}/prefix/bin/relievo build ${SOURCE_DIR}/examples/wolf.svg -q -o ${WORK_DIR}/built.glb)
run(${CMAKE_COMMAND} -E compare_files ${WORK_DIR}/embedded.glb ${WORK_DIR}/built.glb)
