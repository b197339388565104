/// Data sets: the samples of a plan in the order of its cases, in archives by split, with a table of
/// labels, a card and the plan itself. The same bytes whoever made the samples, in whatever shards.
#pragma once

#include <string>

#include "app/cli/stop_signal.h"
#include "app/sweep/plan.h"

namespace wuerfel {

struct DatasetCounts {
  long samples = 0;
  long failed = 0;
};

/// Throws UsageError where cases are missing or samples are damaged, OutputError and Interrupted.
DatasetCounts merge_dataset(const Plan& plan, const std::string& folder, const StopSignal& stop);

/// What is checked of a data set.
struct VerifyChoice {
  std::string id;     ///< of one sample; empty: many
  long sample = 100;  ///< how many, evenly spread; 0: all
  int threads = 0;
};

struct VerifyReport {
  long checked = 0;
  std::vector<std::string> differences;  ///< in words
  long near = 0;  ///< samples whose pictures are the same within what other machines draw
};

/// Makes samples again and compares: labels and states bit by bit, pictures as `compare` does.
/// Throws UsageError where the folder is no whole data set of this version of the program.
VerifyReport verify_dataset(const std::string& folder,
                            const VerifyChoice& choice,
                            const StopSignal& stop);

}  // namespace wuerfel
