/// RasterThreads: how many threads may draw.
#pragma once

namespace wuerfel {

/// How many threads the rasteriser may use. It reads this once per process, when the first context
/// is made.
enum class RasterThreads {
  all,     ///< one per core: single pictures
  caller,  ///< the drawing thread alone: another stage of a pipeline fills the other cores
};

}  // namespace wuerfel
