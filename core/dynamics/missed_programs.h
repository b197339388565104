/// Programs whose answer is used although it missed its tolerance, for whoever wants to see them again.
#pragma once

#include <functional>

#include "core/qp/coulomb/friction_program.h"

namespace wuerfel {

/// While it lives it is told of such programs of its thread. One at a time.
class MissedProgramListener {
 public:
  using Hear = std::function<void(const FrictionProgram&)>;
  explicit MissedProgramListener(Hear hear);
  ~MissedProgramListener();
  MissedProgramListener(const MissedProgramListener&) = delete;
  MissedProgramListener& operator=(const MissedProgramListener&) = delete;

  /// Without contacts where nothing rubs.
  static void tell(const FrictionProgram& program);

 private:
  Hear hear_;
};

}  // namespace wuerfel
