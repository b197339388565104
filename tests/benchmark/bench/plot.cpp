#include "tests/benchmark/bench/plot.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <system_error>

#include <fmt/core.h>

#include "app/output/text_output.h"
#include "render/error.h"
#include "render/files/child_process.h"
#include "tests/benchmark/bench/scenes.h"

namespace wuerfel {

namespace {

/// Errors below are drawn here: equal doubles have no logarithm.
constexpr double error_floor = 1e-17;

struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Line {
  std::string label;
  std::vector<Point> points;
};

struct Figure {
  std::string name;
  std::string title;
  std::string x_label;
  std::string y_label;
  std::string range;  ///< further gnuplot commands
  std::vector<Line> lines;
};

// The colours of Okabe and Ito without yellow: told apart by colour-blind people, and by their
// marks and dashes in print without colours.
constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                             "#000000", "#E69F00", "#56B4E9"};
constexpr std::array marks{7, 5, 9, 11, 13, 4, 6, 8, 10, 12, 1, 2, 3};

Line& line_of(std::vector<Line>& lines, const std::string& label) {
  const auto found = std::find_if(lines.begin(), lines.end(),
                                  [&](const Line& line) { return line.label == label; });
  if (found != lines.end()) return *found;
  lines.push_back({label, {}});
  return lines.back();
}

std::string line_label(const BenchRow& row) { return fmt::format("{} {}", row.engine, row.method); }

std::string script(const Figure& figure, const BenchMachine& machine, const std::string& folder) {
  std::string text =
      fmt::format("# {} | {} | {}\n", machine.cpu, machine.compiler, machine.version);
  for (std::size_t k = 0; k < figure.lines.size(); ++k) {
    text += fmt::format("$line{} << EOD\n", k);
    for (const Point& point : figure.lines[k].points)
      text += fmt::format("{:.6g} {:.6g}\n", point.x, point.y);
    text += "EOD\n";
  }
  text += fmt::format(
      "set title '{}' noenhanced\nset xlabel '{}'\nset ylabel '{}'\nset logscale xy\n"
      "set format xy '10^{{%T}}'\nset grid back lc rgb '#cccccc' lw 0.5\nset border 3\n"
      "set tics nomirror\nset key outside right top noenhanced spacing 1.2\n{}\n",
      figure.title, figure.x_label, figure.y_label, figure.range);
  std::string plot = "plot ";
  for (std::size_t k = 0; k < figure.lines.size(); ++k) {
    plot +=
        fmt::format("{}$line{} with linespoints lc rgb '{}' dt {} lw 1.5 pt {} ps 0.7 title '{}'",
                    k == 0 ? "" : ", \\\n  ", k, colours.at(k % colours.size()),
                    1 + k / colours.size(), marks.at(k % marks.size()), figure.lines[k].label);
  }
  const std::string base = (std::filesystem::path(folder) / figure.name).string();
  text += fmt::format(
      "set terminal svg size 900,520 font 'DejaVu Sans,13' background 'white'\nset output "
      "'{}.svg'\n{}\n",
      base, plot);
  text += fmt::format(
      "set terminal pngcairo size 1350,780 font 'DejaVu Sans,13' linewidth 1.5\nset output "
      "'{}.png'\n{}\n",
      base, plot);
  return text;
}

void draw(const Figure& figure,
          const BenchMachine& machine,
          const std::string& folder,
          std::vector<std::string>& files) {
  if (figure.lines.empty()) return;
  const std::string base = (std::filesystem::path(folder) / figure.name).string();
  const std::string script_file = base + ".gp";
  write_text(script_file, script(figure, machine, folder));
  ChildProcess gnuplot({"gnuplot", script_file});
  if (gnuplot.wait() != 0) {
    throw OutputError(
        fmt::format("gnuplot could not draw {}: {}", script_file, gnuplot.error_output()));
  }
  for (const char* ending : {".gp", ".svg", ".png"})
    files.push_back(base + ending);
}

Figure error_figure(const std::vector<BenchRow>& rows, const std::string& scene) {
  Figure figure;
  figure.name = "error-" + scene;
  figure.title = make_bench_scene(scene).scene.title;
  figure.x_label = "CPU time / s";
  figure.y_label = "error of the state at the end, relative";
  figure.range = "set yrange [:10]";
  for (const BenchRow& row : rows) {
    if (row.scene != scene || !row.state_error || row.repeats == 0) continue;
    line_of(figure.lines, line_label(row))
        .points.push_back({row.cpu, std::max(*row.state_error, error_floor)});
  }
  return figure;
}

// "tower" of "tower_10"; empty where the name does not tell a size.
std::string family_of(const std::string& scene) {
  for (const char* family : {"tower", "pyramid", "wall", "pile"})
    if (scene.starts_with(fmt::format("{}_", family))) return family;
  return {};
}

void add_growth(const std::vector<BenchRow>& rows,
                const std::function<std::string(const BenchRow&)>& label,
                Figure& figure) {
  for (const BenchRow& row : rows) {
    const std::string family = family_of(row.scene);
    const std::string name = label(row);
    if (family.empty() || name.empty() || row.repeats == 0) continue;
    line_of(figure.lines, name).points.push_back({static_cast<double>(row.bodies), row.cpu});
  }
  std::erase_if(figure.lines, [](const Line& line) { return line.points.size() < 2; });
  for (Line& line : figure.lines) {
    std::sort(line.points.begin(), line.points.end(),
              [](const Point& a, const Point& b) { return a.x < b.x; });
  }
}

Figure growth_figure(const std::vector<BenchRow>& rows) {
  Figure figure;
  figure.name = "growth";
  figure.title = "from nothing to certified rest (pile: 2 s of falling)";
  figure.x_label = "cubes";
  figure.y_label = "CPU time / s";
  add_growth(
      rows,
      [](const BenchRow& row) {
        return row.method == "auto/rigid/auto" ? family_of(row.scene) : std::string{};
      },
      figure);
  return figure;
}

Figure solver_figure(const std::vector<BenchRow>& rows) {
  Figure figure;
  figure.name = "solvers";
  figure.title = "solvers: from nothing to certified rest";
  figure.x_label = "cubes";
  figure.y_label = "CPU time / s";
  constexpr std::string_view prefix = "event/rigid/";
  add_growth(
      rows,
      [prefix](const BenchRow& row) {
        const std::string family = family_of(row.scene);
        if (!row.method.starts_with(prefix) || family == "pile") return std::string{};
        return fmt::format("{}, {}", family, row.method.substr(prefix.size()));
      },
      figure);
  return figure;
}

}  // namespace

std::vector<std::string> draw_bench_plots(const std::vector<BenchRow>& rows,
                                          const BenchMachine& machine,
                                          const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
    throw OutputError(fmt::format("cannot make the folder {}: {}", folder, problem.message()));
  std::vector<std::string> files;
  for (const std::string& scene : bench_motions())
    draw(error_figure(rows, scene), machine, folder, files);
  draw(growth_figure(rows), machine, folder, files);
  draw(solver_figure(rows), machine, folder, files);
  return files;
}

}  // namespace wuerfel
