/// Many scenes in one process: no process per scene, no state between them.
#pragma once

#include <exception>
#include <span>
#include <vector>

#include "core/check.h"
#include "core/work_in_order.h"

namespace wuerfel {

/// The answer to one of many, or what was thrown in its place.
template <class Answer>
struct Attempt {
  Answer answer;
  std::exception_ptr failure;  ///< null: there is an answer
};

/// What `work()` returns, or what it throws.
template <class Work>
auto attempt(Work work) {
  Attempt<std::invoke_result_t<Work&>> result;
  try {
    result.answer = work();
  } catch (...) {
    result.failure = std::current_exception();
  }
  return result;
}

/// `check` of every scene, in their order: the same answers for any number of threads.
std::vector<Attempt<Check>> check_many(std::span<const Scene> scenes,
                                       const MotionSettings& settings,
                                       const Workforce& workforce);

}  // namespace wuerfel
