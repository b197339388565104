# The files that drawing needs, inside the program: nothing is looked up at run time.
# EMBED name, file: symbols name_begin and name_end around the file's bytes.
.macro EMBED name, file
  .global embedded_\name\()_begin
  .global embedded_\name\()_end
  .balign 16
embedded_\name\()_begin:
  .incbin "\file"
embedded_\name\()_end:
  .byte 0
.endm

  .section .rodata
  EMBED font, "fonts/DejaVuSans.ttf"
  EMBED box_vert, "shaders/box.vert"
  EMBED box_frag, "shaders/box.frag"
  EMBED segment_vert, "shaders/segment.vert"
  EMBED segment_frag, "shaders/segment.frag"
  EMBED arrow_vert, "shaders/arrow.vert"
  EMBED arrow_frag, "shaders/arrow.frag"
  EMBED disc_vert, "shaders/disc.vert"
  EMBED disc_frag, "shaders/disc.frag"
  EMBED triangle_vert, "shaders/triangle.vert"
  EMBED triangle_frag, "shaders/triangle.frag"

  .section .note.GNU-stack, "", @progbits
