# Plants equations one by one and fails where equations.cmake lets one pass.
# Run: cmake -DRULES=<equations.cmake> -DSCRATCH=<folder> -P equations_catch.cmake
cmake_minimum_required(VERSION 3.25)

function(planted file line result)
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/${file} "${line}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${SCRATCH} -P ${RULES} RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
  set(${result} ${code} PARENT_SCOPE)
endfunction()

foreach(line IN ITEMS
    "const Vec2 n = perp(c.arm_j - c.arm_i)|" "return 2.0 * det(v_j - v_i, v_k - v_i)|" "return det(p_j - p_i, p_k - p_i)|"
    "n.dot(v.v_k - c.alpha * v.v_j - (1.0 - c.alpha) * v.v_i)|" "const double c = (v_i - v_j).squaredNorm()|"
    "b.velocity - a.velocity + b.spin * perp(r)|" "          b.acceleration.linear + b.acceleration.angular * perp(arm)|" "- b.spin * b.spin * r}|"
    "a - omega * omega * box.arm[k])|")
  string(REPLACE "|" "" line "${line}")
  planted(core/time/x.cpp "${line}" code)
  if(code EQUAL 0)
    message(SEND_ERROR "not caught: ${line}")
  endif()
endforeach()
planted(core/constraints/side.h "const Vec2 n = perp(p_j - p_i)" code)
planted(core/model/state.h "return v + omega * perp(r)" code_of_chain_rule)
planted(core/time/x.cpp "/// n = perp(p_j - p_i) points out" code_of_comment)
if(NOT code EQUAL 0 OR NOT code_of_chain_rule EQUAL 0 OR NOT code_of_comment EQUAL 0)
  message(SEND_ERROR "wrongly refused")
endif()
file(REMOVE_RECURSE ${SCRATCH})
