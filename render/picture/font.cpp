#include "render/picture/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_STROKER_H

#include <cmath>

#include "render/error.h"

// DejaVu Sans as a TrueType file (embedded.S).
extern "C" {
extern const std::uint8_t embedded_font_begin[];
extern const std::uint8_t embedded_font_end[];
}

namespace wuerfel {
namespace {

constexpr double per_pixel = 64.0;  ///< FreeType counts 1/64 px
constexpr char32_t replacement = 0xFFFD;

long fixed_point(double pixels) { return std::lround(pixels * per_pixel); }

/// Number of bytes that follow a first byte, or -1.
int continuation_bytes(unsigned first) {
  if (first < 0x80U) return 0;
  if (first >= 0xC2U && first < 0xE0U) return 1;
  if (first >= 0xE0U && first < 0xF0U) return 2;
  if (first >= 0xF0U && first < 0xF5U) return 3;
  return -1;
}

/// Draws the outline at hand into a bitmap.
Glyph rasterise(FT_Glyph outline) {
  FT_Glyph bitmap = outline;
  Glyph glyph;
  if (FT_Glyph_To_Bitmap(&bitmap, FT_RENDER_MODE_NORMAL, nullptr, 0) != 0) return glyph;
  const auto* const drawn = reinterpret_cast<FT_BitmapGlyph>(bitmap);
  glyph.left = drawn->left;
  glyph.top = drawn->top;
  glyph.width = static_cast<int>(drawn->bitmap.width);
  glyph.height = static_cast<int>(drawn->bitmap.rows);
  for (int y = 0; y < glyph.height; ++y) {
    const std::uint8_t* row =
        drawn->bitmap.buffer + static_cast<std::ptrdiff_t>(y) * drawn->bitmap.pitch;
    glyph.coverage.insert(glyph.coverage.end(), row, row + glyph.width);
  }
  FT_Done_Glyph(bitmap);
  return glyph;
}

}  // namespace

char32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto byte = [&text](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(text[i]));
  };
  const unsigned first = byte(at++);
  const int more = continuation_bytes(first);
  if (more <= 0) return more == 0 ? static_cast<char32_t>(first) : replacement;
  unsigned code = first & (0x3FU >> static_cast<unsigned>(more));
  for (int i = 0; i < more; ++i) {
    if (at >= text.size() || (byte(at) & 0xC0U) != 0x80U) return replacement;
    code = (code << 6U) | (byte(at++) & 0x3FU);
  }
  return static_cast<char32_t>(code);
}

void Font::LibraryDeleter::operator()(FT_LibraryRec_* library) const { FT_Done_FreeType(library); }
void Font::FaceDeleter::operator()(FT_FaceRec_* face) const { FT_Done_Face(face); }

Font::Font() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw LibraryError("FreeType does not start");
  library_.reset(library);
  const auto size = static_cast<FT_Long>(embedded_font_end - embedded_font_begin);
  FT_Face face = nullptr;
  if (FT_New_Memory_Face(library, embedded_font_begin, size, 0, &face) != 0) {
    throw LibraryError("the font built into the program does not open");
  }
  face_.reset(face);
}

Font::~Font() = default;

FT_FaceRec_* Font::face() { return face_.get(); }

unsigned long Font::glyph_index(char32_t letter) { return FT_Get_Char_Index(face_.get(), letter); }

void Font::select_size(double size) {
  const long wanted = fixed_point(size);
  if (wanted == selected_size_) return;
  FT_Set_Char_Size(face_.get(), 0, wanted, 72, 72);
  selected_size_ = wanted;
}

double Font::advance(char32_t letter, char32_t next, double size) {
  const auto [known, is_new] = advances_.try_emplace({letter, next, fixed_point(size)});
  if (is_new) known->second = measured_advance(letter, next, size);
  return known->second;
}

double Font::measured_advance(char32_t letter, char32_t next, double size) {
  select_size(size);
  const FT_UInt index = FT_Get_Char_Index(face_.get(), letter);
  FT_Fixed advance = 0;  // 16.16, not rounded to whole pixels
  if (FT_Load_Glyph(face_.get(), index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) == 0) {
    advance = face_->glyph->linearHoriAdvance;
  }
  double pixels = static_cast<double>(advance) / 65536.0;
  if (next != 0 && FT_HAS_KERNING(face_.get())) {
    FT_Vector kerning{};
    FT_Get_Kerning(face_.get(), index, FT_Get_Char_Index(face_.get(), next), FT_KERNING_UNFITTED,
                   &kerning);
    pixels += static_cast<double>(kerning.x) / per_pixel;
  }
  return pixels;
}

double Font::width(std::string_view text, double size) {
  double total = 0.0;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t letter = next_code_point(text, at);
    std::size_t peek = at;
    total += advance(letter, at < text.size() ? next_code_point(text, peek) : 0, size);
  }
  return total;
}

const Glyph& Font::glyph(char32_t letter, double size, int phase, double halo) {
  const Key key{letter, fixed_point(size), phase, fixed_point(halo)};
  const auto found = glyphs_.find(key);
  if (found != glyphs_.end()) return found->second;
  Glyph& entry = glyphs_[key];
  select_size(size);
  FT_Glyph outline = nullptr;
  if (FT_Load_Char(face_.get(), letter, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0
      || FT_Get_Glyph(face_->glyph, &outline) != 0) {
    return entry;
  }
  if (halo > 0.0) {
    FT_Stroker stroker = nullptr;
    FT_Stroker_New(library_.get(), &stroker);
    FT_Stroker_Set(stroker, fixed_point(halo), FT_STROKER_LINECAP_ROUND, FT_STROKER_LINEJOIN_ROUND,
                   0);
    FT_Glyph_StrokeBorder(&outline, stroker, 0, 1);
    FT_Stroker_Done(stroker);
  }
  FT_Vector shift{phase * 16L, 0};
  FT_Glyph_Transform(outline, nullptr, &shift);
  entry = rasterise(outline);
  FT_Done_Glyph(outline);
  return entry;
}

}  // namespace wuerfel
