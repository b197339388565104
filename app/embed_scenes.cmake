# Writes a C++ source that holds scene files as text.
# Run: cmake -DFOLDER=<assets/scenes> -DOUTPUT=<file.cpp> -P embed_scenes.cmake
cmake_minimum_required(VERSION 3.25)

file(GLOB files LIST_DIRECTORIES false ${FOLDER}/*.toml)
list(SORT files)
set(entries "")
list(LENGTH files count)
foreach(path IN LISTS files)
  get_filename_component(name ${path} NAME_WE)
  file(READ ${path} text)
  string(APPEND entries "    {\"${name}\", R\"scene(${text})scene\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from assets/scenes by app/embed_scenes.cmake.
#include \"app/cli/shipped_scenes.h\"

#include <array>

namespace wuerfel {

namespace {

constexpr std::array<ShippedScene, ${count}> scenes{{
${entries}}};

}  // namespace

std::span<const ShippedScene> shipped_scenes() { return scenes; }

}  // namespace wuerfel
")
