#include "render/vector/svg_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "core/geometry/trig.h"
#include "render/error.h"
#include "render/vector/outlines.h"
#include "render/vector/xml.h"

namespace wuerfel::internal {
namespace {

/// Hundredths of a pixel, without zeros that say nothing.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string place(Point p) { return number(p.x) + " " + number(p.y); }

std::string hex(Color color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

/// `kind="#rrggbb"`, and its opacity where it has one.
std::string paint(std::string_view kind, Color color) {
  std::string text = fmt::format(" {}=\"{}\"", kind, hex(color));
  if (color.a < 255) text += fmt::format(" {}-opacity=\"{}\"", kind, number(color.a / 255.0));
  return text;
}

std::string polygon(std::span<const Point> corners) {
  std::string path = "M" + place(corners.front());
  for (const Point& corner : corners.subspan(1))
    path += "L" + place(corner);
  return path + "Z";
}

/// -1 where a box stands for none.
int body_of(const DrawList& list, std::size_t box) {
  const auto found = std::ranges::lower_bound(list.bodies, box, {}, &BodyBox::box);
  return found != list.bodies.end() && found->box == box ? found->body : -1;
}

bool same_but_for_alpha(const SegmentShape& a, const SegmentShape& b) {
  return a.half_width == b.half_width && a.round == b.round && a.color.r == b.color.r
         && a.color.g == b.color.g && a.color.b == b.color.b;
}

bool follows(const SegmentShape& a, const SegmentShape& b) { return a.to == b.from; }

/// What may stand in an id: no blanks.
std::string id_of(const std::string& prefix, const std::string& name) {
  std::string id = prefix + "body-" + name;
  std::ranges::replace_if(
      id, [](char c) { return c == ' ' || c == '\t' || c == '\n'; }, '_');
  return xml_escaped(id);
}

}  // namespace

SvgWriter::SvgWriter(int width, int height, const FigureTexts& texts) : texts_(&texts) {
  const std::string size =
      texts.width_mm > 0.0 ? fmt::format(R"(width="{}mm" height="{}mm")", number(texts.width_mm),
                                         number(texts.width_mm * height / width))
                           : fmt::format(R"(width="{}" height="{}")", width, height);
  svg_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" {} viewBox=\"0 0 {} {}\" "
      "font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n",
      size, width, height);
  if (!texts.title.empty()) svg_ += fmt::format("<title>{}</title>\n", xml_escaped(texts.title));
  if (!texts.description.empty())
    svg_ += fmt::format("<desc>{}</desc>\n", xml_escaped(texts.description));
  if (texts.origin.empty()) return;
  svg_ += "<metadata>\n";
  for (const PngText& text : texts.origin) {
    svg_ += fmt::format("<text xmlns=\"urn:wuerfel:origin\" key=\"{}\">{}</text>\n",
                        xml_escaped(text.key), xml_escaped(text.value));
  }
  svg_ += "</metadata>\n";
}

std::string SvgWriter::finish() {
  svg_ += "</svg>\n";
  return std::move(svg_);
}

void SvgWriter::open_group(std::string_view name) {
  close_group();
  svg_ += fmt::format("<g class=\"{}\">\n", name);
  in_group_ = true;
}

void SvgWriter::close_group() {
  if (in_group_) svg_ += "</g>\n";
  in_group_ = false;
}

void SvgWriter::add(const DrawList& list, int x, int y, const std::string& prefix) {
  prefix_ = prefix;
  svg_ += fmt::format(
      "<clipPath id=\"{0}clip{1}\"><rect width=\"{2}\" height=\"{3}\"/></clipPath>\n"
      "<g transform=\"translate({4} {5})\" clip-path=\"url(#{0}clip{1})\">\n",
      prefix, clips_, list.width, list.height, x, y);
  ++clips_;
  if (list.background.a > 0) {
    svg_ += fmt::format("<rect class=\"background\" width=\"{}\" height=\"{}\"{}/>\n", list.width,
                        list.height, paint("fill", list.background));
  }
  auto group = list.groups.begin();
  std::size_t shape = 0;
  for (const ShapeRun& run : list.runs) {
    for (std::size_t i = run.first; i < run.first + run.count;) {
      while (group != list.groups.end() && group->shape <= shape)
        open_group((group++)->name);
      const std::size_t left = run.first + run.count - i;
      const std::size_t in_group =
          group == list.groups.end() ? left : std::min(left, group->shape - shape);
      const std::size_t next =
          run.kind == ShapeKind::segment ? add_strokes(list, i, i + in_group) : i + 1;
      if (run.kind != ShapeKind::segment) add_shape(list, run, i);
      shape += next - i;
      i = next;
    }
  }
  close_group();
  if (!list.texts.empty()) open_group("texts");
  for (const TextShape& text : list.texts)
    add(text);
  close_group();
  svg_ += "</g>\n";
}

void SvgWriter::add_shape(const DrawList& list, const ShapeRun& run, std::size_t i) {
  switch (run.kind) {
    case ShapeKind::box:
      return add(list.boxes[i], body_of(list, i));
    case ShapeKind::arrow:
      return add(list.arrows[i]);
    case ShapeKind::disc:
      return add(list.discs[i]);
    case ShapeKind::triangle:
      return add(list.triangles[i]);
    case ShapeKind::segment:
      return;
  }
}

void SvgWriter::add(const BoxShape& box, int body) {
  const auto width = static_cast<double>(box.outline_width);
  const Point center = point(box.center);
  const double half_width = static_cast<double>(box.half_size.x) - 0.5 * width;
  const double half_height = static_cast<double>(box.half_size.y) - 0.5 * width;
  std::string who;
  if (body >= 0) {
    who = " class=\"body\"";
    if (body < std::ssize(texts_->bodies))
      who += fmt::format(" id=\"{}\"", id_of(prefix_, texts_->bodies[body]));
  }
  svg_ += fmt::format("<rect{} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", who,
                      number(center.x - half_width), number(center.y - half_height),
                      number(2.0 * half_width), number(2.0 * half_height));
  if (box.axis.y != 0.0F || box.axis.x < 0.0F) {
    const double angle =
        wuerfel::atan2(static_cast<double>(box.axis.y), static_cast<double>(box.axis.x));
    svg_ += fmt::format(" transform=\"rotate({:.4f} {})\"", angle * 180.0 / std::numbers::pi,
                        place(center));
  }
  svg_ += paint("fill", box.fill);
  if (width > 0.0)
    svg_ += paint("stroke", box.outline) + fmt::format(" stroke-width=\"{}\"", number(width));
  svg_ += "/>\n";
  if (box.diagonal_width <= 0.0F) return;
  const auto ends = corners(box, width);
  svg_ += fmt::format("<path d=\"M{}L{}M{}L{}\"{} stroke-width=\"{}\"/>\n", place(ends[0]),
                      place(ends[2]), place(ends[1]), place(ends[3]), paint("stroke", box.outline),
                      number(static_cast<double>(box.diagonal_width)));
}

void SvgWriter::add(const ArrowShape& arrow) {
  svg_ += fmt::format("<path d=\"{}\"{}", polygon(outline(arrow)), paint("fill", arrow.color));
  if (arrow.grow > 0.0F) {
    svg_ += paint("stroke", arrow.color)
            + fmt::format(" stroke-width=\"{}\"", number(2.0 * static_cast<double>(arrow.grow)));
  }
  svg_ += "/>\n";
}

void SvgWriter::add(const DiscShape& disc) {
  const auto width = static_cast<double>(disc.outline_width);
  svg_ +=
      fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}", number(point(disc.center).x),
                  number(point(disc.center).y),
                  number(static_cast<double>(disc.radius) - 0.5 * width), paint("fill", disc.fill));
  if (width > 0.0)
    svg_ += paint("stroke", disc.outline) + fmt::format(" stroke-width=\"{}\"", number(width));
  svg_ += "/>\n";
}

void SvgWriter::add(const TriangleShape& triangle) {
  const auto width = static_cast<double>(triangle.outline_width);
  svg_ += fmt::format("<path d=\"{}\"{}", polygon(corners(triangle, 0.5 * width)),
                      paint("fill", triangle.fill));
  if (width > 0.0)
    svg_ += paint("stroke", triangle.outline) + fmt::format(" stroke-width=\"{}\"", number(width));
  svg_ += "/>\n";
}

std::size_t SvgWriter::add_strokes(const DrawList& list, std::size_t first, std::size_t end) {
  const auto& strokes = list.segments;
  const SegmentShape& style = strokes[first];
  std::size_t next = first + 1;
  // A line that fades is one path with a gradient; other strokes of one colour are one path, too.
  const bool line =
      next < end && follows(style, strokes[next]) && !(style.color == strokes[next].color);
  const auto belongs = [&](std::size_t i) {
    return same_but_for_alpha(style, strokes[i])
           && (line ? follows(strokes[i - 1], strokes[i]) : style.color == strokes[i].color);
  };
  while (next < end && belongs(next))
    ++next;
  std::string path;
  for (std::size_t i = first; i < next; ++i) {
    if (i == first || !follows(strokes[i - 1], strokes[i]))
      path += "M" + place(point(strokes[i].from));
    path += "L" + place(point(strokes[i].to));
  }
  std::string stroke = paint("stroke", style.color);
  const SegmentShape& last = strokes[next - 1];
  if (line && next - first > 1) {
    const auto stop = [](int offset, Color color) {
      return fmt::format("<stop offset=\"{}\" stop-color=\"{}\" stop-opacity=\"{}\"/>", offset,
                         hex(color), number(color.a / 255.0));
    };
    svg_ += fmt::format(
        "<linearGradient id=\"{0}fade{1}\" gradientUnits=\"userSpaceOnUse\" x1=\"{2}\" y1=\"{3}\" "
        "x2=\"{4}\" y2=\"{5}\">{6}{7}</linearGradient>\n",
        prefix_, gradients_, number(point(style.from).x), number(point(style.from).y),
        number(point(last.to).x), number(point(last.to).y), stop(0, style.color),
        stop(1, last.color));
    stroke = fmt::format(" stroke=\"url(#{}fade{})\"", prefix_, gradients_);
    ++gradients_;
  }
  svg_ += fmt::format("<path d=\"{}\" fill=\"none\"{} stroke-width=\"{}\"{}/>\n", path, stroke,
                      number(2.0 * static_cast<double>(style.half_width)),
                      style.round > 0.5F ? " stroke-linecap=\"round\"" : "");
  return next;
}

void SvgWriter::add(const TextShape& text) {
  svg_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}", number(point(text.baseline).x),
                      number(point(text.baseline).y), number(static_cast<double>(text.size)),
                      paint("fill", text.color));
  if (text.halo_width > 0.0F && text.halo.a > 0) {
    svg_ += paint("stroke", text.halo)
            + fmt::format(" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                          number(2.0 * static_cast<double>(text.halo_width)));
  }
  svg_ += fmt::format(">{}</text>\n", xml_escaped(text.text));
}

std::vector<PngText> origin_of_svg(std::string_view svg) {
  constexpr std::string_view start = "<text xmlns=\"urn:wuerfel:origin\" key=\"";
  std::vector<PngText> texts;
  for (std::size_t at = svg.find(start); at != std::string_view::npos; at = svg.find(start, at)) {
    at += start.size();
    const std::size_t quote = svg.find('"', at);
    const std::size_t open = svg.find('>', at);
    const std::size_t close = svg.find("</text>", at);
    if (close == std::string_view::npos || quote > open || open > close)
      throw RenderError("the texts of the SVG file are damaged");
    texts.push_back({xml_unescaped(svg.substr(at, quote - at)),
                     xml_unescaped(svg.substr(open + 1, close - open - 1))});
  }
  return texts;
}

}  // namespace wuerfel::internal
