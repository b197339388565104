# Fails where a source file is not formatted as .clang-format says.
# Run: cmake -DROOT=<source folder> -DCLANG_FORMAT=<program> -P format.cmake
cmake_minimum_required(VERSION 3.25)

set(sources "")
foreach(folder IN ITEMS app core render tests)
  file(GLOB_RECURSE found ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  list(APPEND sources ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror --style=file ${sources}
                RESULT_VARIABLE code ERROR_VARIABLE complaints)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "run clang-format -i on what is named here:\n${complaints}")
endif()
