# Fails where a module includes what it must not know:
#   app -> render -> core/snapshot.h,  app -> core
#   inside core: geometry <- scene <- model <- constraints <- dynamics <- statics <- time, and qp beside them
# Run: cmake -DROOT=<source folder> -P include_rules.cmake
cmake_minimum_required(VERSION 3.25)

set(project_folders "app|core|render|tests|assets")
set(library_headers "GL/|ft2build|png\\.h|cairo|isa-l|coin|Ip[A-Z]|toml\\+\\+/|nlohmann/|CLI/|Eigen/|fmt/|gtest/|gmock/")

# Every include of a file of `files` that looks like one of the project's own or of a known library has to match one of
# the patterns that follow.
function(may_include files)
  list(JOIN ARGN "|" allowed)
  foreach(source IN LISTS files)
    file(STRINGS ${source} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*)[>\"].*$" "\\1" header "${line}")
      if(header MATCHES "^(${project_folders})/|^(${library_headers})" AND NOT header MATCHES "^(${allowed})")
        message(SEND_ERROR "${source} must not include ${header}")
      elseif(line MATCHES "\"" AND NOT header MATCHES "^(${project_folders})/")
        message(SEND_ERROR "${source}: write \"${header}\" from the root")
      endif()
    endforeach()
  endforeach()
endfunction()

function(sources_below folder result)
  file(GLOB_RECURSE found ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# The command line is read in one file, and libraries that are built into the program have a folder.
set(command_line /app/cli/options\\.cpp$)
set(libraries /app/libraries/)
sources_below(app app)
set(app_reads ${app})
set(app_libraries ${app})
list(FILTER app_reads INCLUDE REGEX ${command_line})
list(FILTER app_libraries INCLUDE REGEX ${libraries})
list(REMOVE_ITEM app ${app_reads} ${app_libraries})
may_include("${app}" app/ render/ core/ nlohmann/ fmt/ Eigen/)
may_include("${app_reads}" app/ render/ core/ CLI/ fmt/)
may_include("${app_libraries}" toml\\+\\+/ fmt/)

# Each folder of render knows itself and what stands before it; OpenGL, Cairo and libpng have one folder each.
set(known_render_folders picture raster vector files pipeline)
set(picture render/picture/ "render/(error|shared_library)\\.h" "core/(snapshot|geometry/trig)\\.h" ft2build Eigen/ fmt/)
set(raster ${picture} render/raster/ GL/)
set(vector ${picture} render/vector/ "render/files/png\\.h" cairo)  # the texts that pictures carry are those of PNG files
set(files ${picture} "render/raster/(image|row_set)\\.h" render/files/ png\\.h isa-l)
set(pipeline ${picture} render/raster/ render/files/ render/pipeline/)

foreach(folder IN LISTS known_render_folders)
  sources_below(render/${folder} found)
  may_include("${found}" ${${folder}})
endforeach()

file(GLOB render_root ${ROOT}/render/*.h ${ROOT}/render/*.cpp)
may_include("${render_root}" render/)

# What is installed includes nothing but what is installed, so that users of the library need no OpenGL, Cairo or libpng.
if(EXISTS ${ROOT}/render/CMakeLists.txt)
  file(STRINGS ${ROOT}/render/CMakeLists.txt installed REGEX "^  render/.*\\.h$")
  list(TRANSFORM installed STRIP)
  list(TRANSFORM installed PREPEND ${ROOT}/ OUTPUT_VARIABLE installed_files)
  may_include("${installed_files}" ${installed} core/snapshot\\.h)
endif()

# Each folder of core knows itself and what stands before it.
set(settings core/settings\\.h)
set(known_core_folders geometry scene model constraints dynamics statics qp time)
set(geometry core/geometry/ Eigen/)
set(scene ${geometry} core/scene/ toml\\+\\+/ nlohmann/ fmt/)
set(model ${geometry} "core/scene/(scene|overlap)\\.h" core/model/)
set(constraints ${model} core/constraints/)
set(qp core/qp/ Ip[A-Z] coin Eigen/)
set(dynamics ${constraints} core/dynamics/ "core/qp/((quadratic_program|qp_solver|residual_meter|methods/(canonical_multipliers|equality_solver))\\.h|coulomb/)" ${settings})
set(statics ${dynamics} core/statics/ core/work_in_order\\.h)
set(time ${statics} core/time/ core/snapshot\\.h core/scene/ core/check\\.h fmt/)

foreach(folder IN LISTS known_core_folders)
  sources_below(core/${folder} found)
  may_include("${found}" ${${folder}})
endforeach()

file(GLOB core_root ${ROOT}/core/*.h ${ROOT}/core/*.cpp)
may_include("${core_root}" core/ Eigen/ fmt/)

file(GLOB core_folders RELATIVE ${ROOT}/core LIST_DIRECTORIES true ${ROOT}/core/*)
foreach(folder IN LISTS core_folders)
  if(IS_DIRECTORY ${ROOT}/core/${folder} AND NOT folder IN_LIST known_core_folders)
    message(SEND_ERROR "core/${folder} has no rule in tests/rules/include_rules.cmake")
  endif()
endforeach()
