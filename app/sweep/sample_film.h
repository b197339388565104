/// The film of a sample, as bytes.
#pragma once

#include <memory>
#include <string>

#include "app/cli/stop_signal.h"
#include "app/sweep/sweep_file.h"
#include "render/files/animation.h"

namespace wuerfel {

class SampleFilm {
 public:
  /// Throws OutputError where ffmpeg is missing.
  SampleFilm(const SampleFiles& files, const StopSignal& stop);
  ~SampleFilm();
  SampleFilm(const SampleFilm&) = delete;
  SampleFilm& operator=(const SampleFilm&) = delete;

  void add(const Image& frame) { writer_->add(frame); }
  /// An MP4 file.
  std::string finish();

 private:
  std::string folder_;  // temporary
  std::unique_ptr<AnimationWriter> writer_;
};

}  // namespace wuerfel
