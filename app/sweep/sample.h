/// Samples: what a sweep makes of a case.
#pragma once

#include <string>
#include <vector>

#include "app/cli/stop_signal.h"
#include "app/sweep/case.h"
#include "app/sweep/columns.h"
#include "app/sweep/sample_pictures.h"
#include "app/sweep/tape.h"

namespace wuerfel {

/// A case that could not be made a sample: its motion is not as exact as was asked for.
class SampleError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes samples; from several threads at once.
class SampleMaker {
 public:
  SampleMaker(const Sweep& sweep, const StopSignal& stop) : sweep_(sweep), stop_(stop) {}

  /// Loads what drawing needs; before there are threads.
  void prepare();
  /// All files of the sample, the labels (ID.json) first. A function of the case alone. Throws
  /// SampleError, SceneError, OutputError and Interrupted.
  std::vector<TapeFile> files(const Case& one);

 private:
  const Sweep& sweep_;
  const StopSignal& stop_;
  Renderers renderers_;
};

}  // namespace wuerfel
