# Fails where Eq. (1)-(7) are written out anywhere but in core/constraints/side.h and rod.h, or the chain rule of turning bodies anywhere but in
# core/model/state.h, so that the table of core/README.md stays true.
# Run: cmake -DROOT=<source folder> -P equations.cmake
cmake_minimum_required(VERSION 3.25)

set(name "[A-Za-z0-9_.]*")
# What gives an equation away: the normal of a side, determinants of its points, sums weighted by the place of the corner, squared rates of rods;
# arms that are turned by a rate, and centripetal accelerations.
set(forms
  "perp[(]${name}(p|arm)_j - ${name}(p|arm)_i[)]"
  "det[(]${name}[pv]_[ijk] - "
  "alpha [*] ${name}[va]_j"
  "[(]${name}[pv]_i - ${name}[pv]_j[)][.]squaredNorm"
  "(spin|omega|angular) [*] perp[(]"
  "${name}(spin|omega) [*] ${name}(spin|omega) [*] ${name}(r|arms?)[^a-z.]")
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cpp)
list(REMOVE_ITEM sources core/constraints/side.h core/constraints/rod.h core/model/state.h)
foreach(source IN LISTS sources)
  foreach(form IN LISTS forms)
    file(STRINGS ${ROOT}/${source} lines REGEX "${form}")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "//.*$" "" code "${line}")
      if(code MATCHES "${form}")
        message(SEND_ERROR "${source} writes out an equation that side.h, rod.h or state.h has:\n${line}")
      endif()
    endforeach()
  endforeach()
endforeach()
