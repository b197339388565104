/// Font: the shipped font (DejaVu Sans) through FreeType, unhinted, with a cache of rasterised
/// letters.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

struct FT_FaceRec_;
struct FT_LibraryRec_;

namespace wuerfel {

/// The next code point of UTF-8 `text` at `at`, which moves on; U+FFFD for bytes that are not
/// UTF-8.
char32_t next_code_point(std::string_view text, std::size_t& at);

/// Coverage of one letter, 0..255, row by row.
struct Glyph {
  int left = 0;  ///< px from the pen to the first column
  int top = 0;   ///< px from the baseline up to the first row
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;
};

class Font {
 public:
  /// Opens the embedded font on first use.
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  Font(Font&&) = delete;
  Font& operator=(Font&&) = delete;

  /// Width in pixels of a line of UTF-8 at a size in pixels per em.
  double width(std::string_view text, double size);
  /// Pixels from one letter's pen position to the next one's, kerning with `next` (0: none)
  /// included.
  double advance(char32_t letter, char32_t next, double size);
  /// A letter whose pen stands `phase` quarters of a pixel right of a pixel's left border; widened
  /// by `halo` pixels on all sides.
  const Glyph& glyph(char32_t letter, double size, int phase, double halo);

  /// The number of a letter in the font, 0 where it has none.
  unsigned long glyph_index(char32_t letter);
  /// For other backends: they may change its size, after which this object must not be used for
  /// anything else.
  FT_FaceRec_* face();

 private:
  struct LibraryDeleter {
    void operator()(FT_LibraryRec_* library) const;
  };
  struct FaceDeleter {
    void operator()(FT_FaceRec_* face) const;
  };
  using Key = std::tuple<char32_t, long, int, long>;

  void select_size(double size);
  double measured_advance(char32_t letter, char32_t next, double size);
  std::unique_ptr<FT_LibraryRec_, LibraryDeleter> library_;
  std::unique_ptr<FT_FaceRec_, FaceDeleter> face_;
  long selected_size_ = 0;  ///< 1/64 px
  std::map<Key, Glyph> glyphs_;
  std::map<std::tuple<char32_t, char32_t, long>, double> advances_;
};

}  // namespace wuerfel
