# Builds the outside program against the install tree and, if SUBDIRECTORY is set, with the project as a subdirectory.
# Run: cmake -DROOT=.. -DBUILD=.. -DSCRATCH=.. -P package_test.cmake
cmake_minimum_required(VERSION 3.25)

function(must)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
if(SUBDIRECTORY)
  # Without optimisation: what is tested is that it builds, and Release takes minutes.
  set(options -DWUERFEL_SOURCE=${ROOT} -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS=-O0 -g0")
else()
  must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
  foreach(file IN ITEMS bin/wuerfel share/man/man1/wuerfel-run.1 share/bash-completion/completions/wuerfel)
    if(NOT EXISTS ${SCRATCH}/prefix/${file})
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
  set(options -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_BUILD_TYPE=Release)
endif()
must(${CMAKE_COMMAND} -G Ninja -S ${ROOT}/tests/package -B ${SCRATCH}/build ${options})
must(${CMAKE_COMMAND} --build ${SCRATCH}/build --target outside)
must(${SCRATCH}/build/outside)
