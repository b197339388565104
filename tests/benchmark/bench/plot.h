/// Draws measurements with gnuplot: SVG for pages, PNG for everything else, and the script itself,
/// which carries its data.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/bench/row.h"

namespace wuerfel {

/// Into `folder`, made if it is not there: `error-SCENE` (error against time, for every scene with
/// a known motion), `growth` (time against the number of cubes, default method) and `solvers` (the
/// same by solver, for towers). A figure that has nothing to show is not made. Returns the names of
/// the files. Throws OutputError, also where there is no gnuplot.
std::vector<std::string> draw_bench_plots(const std::vector<BenchRow>& rows,
                                          const BenchMachine& machine,
                                          const std::string& folder);

}  // namespace wuerfel
