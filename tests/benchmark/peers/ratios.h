/// Time at equal error and error at equal time, from rows of one run.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/bench/row.h"

namespace wuerfel::bench {

/// A Markdown table, one line per scene and engine. Time at equal error: the peer's most accurate
/// row against the cheapest row of ours that is at least as accurate. Error at equal time: the
/// peer's best error among rows that cost no more than ours at the default tolerance (or its
/// cheapest row, if all cost more) against ours. Errors count as 1e-16 at least;
/// above 0.5 a row is lost (fallen, passed through) and has no ratio. Below the table a line for
/// every row that reaches neither ten times less time nor 1e4 times less error, which says why not.
std::string ratio_table(const std::vector<BenchRow>& rows);

}  // namespace wuerfel::bench
