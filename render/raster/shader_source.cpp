#include "render/raster/shader_source.h"

extern "C" {
extern const char embedded_box_vert_begin[], embedded_box_vert_end[];
extern const char embedded_box_frag_begin[], embedded_box_frag_end[];
extern const char embedded_segment_vert_begin[], embedded_segment_vert_end[];
extern const char embedded_segment_frag_begin[], embedded_segment_frag_end[];
extern const char embedded_arrow_vert_begin[], embedded_arrow_vert_end[];
extern const char embedded_arrow_frag_begin[], embedded_arrow_frag_end[];
extern const char embedded_disc_vert_begin[], embedded_disc_vert_end[];
extern const char embedded_disc_frag_begin[], embedded_disc_frag_end[];
extern const char embedded_triangle_vert_begin[], embedded_triangle_vert_end[];
extern const char embedded_triangle_frag_begin[], embedded_triangle_frag_end[];
}

namespace wuerfel::internal {

ShaderSource embedded_shader(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::segment:
      return {{embedded_segment_vert_begin, embedded_segment_vert_end},
              {embedded_segment_frag_begin, embedded_segment_frag_end}};
    case ShapeKind::arrow:
      return {{embedded_arrow_vert_begin, embedded_arrow_vert_end},
              {embedded_arrow_frag_begin, embedded_arrow_frag_end}};
    case ShapeKind::disc:
      return {{embedded_disc_vert_begin, embedded_disc_vert_end},
              {embedded_disc_frag_begin, embedded_disc_frag_end}};
    case ShapeKind::triangle:
      return {{embedded_triangle_vert_begin, embedded_triangle_vert_end},
              {embedded_triangle_frag_begin, embedded_triangle_frag_end}};
    case ShapeKind::box:
      break;
  }
  return {{embedded_box_vert_begin, embedded_box_vert_end},
          {embedded_box_frag_begin, embedded_box_frag_end}};
}

}  // namespace wuerfel::internal
