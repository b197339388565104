#include "app/film/camera.h"

#include <gtest/gtest.h>

#include "app/cli/exit_code.h"
#include "tests/support/image_scenes.h"

namespace wuerfel::test {
namespace {

TEST(Camera, LooksAtTheWindowGiven) {
  const View view = camera_view(parse_camera("1,2.5,8"), {}, 800, 400);
  EXPECT_EQ(view.center, Vec2(1.0, 2.5));
  EXPECT_EQ(view.pixels_per_metre, 100.0);
}

TEST(Camera, ZoomsByAFactor) {
  Camera camera = parse_camera("1,2.5,8");
  camera.zoom = 2.0;
  EXPECT_EQ(camera_view(camera, {}, 800, 400).pixels_per_metre, 200.0);
}

TEST(Camera, KeepsABodyInTheMiddle) {
  Snapshot snapshot = test::pyramid_snapshot();
  const Camera camera = parse_camera("follow:g");
  for (int i = 0; i < 3; ++i) {
    snapshot.boxes[6].center += Vec2(0.5, -0.25);
    const View view = camera_view(camera, snapshot, 640, 360);
    EXPECT_EQ(view.to_pixel(snapshot.boxes[6].center), Vec2(320.0, 180.0));
    EXPECT_DOUBLE_EQ(view.pixels_per_metre, 640.0 / 14.0);
  }
}

TEST(Camera, NamesTheBodyThatIsNotThere) {
  EXPECT_THROW(camera_view(parse_camera("follow:nobody"), test::pyramid_snapshot(), 64, 36),
               UsageError);
}

TEST(Camera, IsWrittenSoThatItCanBeReadAgain) {
  for (const char* text : {"fit", "0.1,-0.30000000000000004,7.3", "1e-3,2,1e+300"}) {
    const Camera camera = parse_camera(text);
    const std::string written = option_text(camera).substr(std::string("--view ").size());
    const Camera again = parse_camera(written);
    EXPECT_EQ(again.center, camera.center) << text;
    EXPECT_EQ(again.width, camera.width) << text;
  }
  Camera camera = parse_camera("follow:the blue one");
  camera.zoom = 1.5;
  EXPECT_EQ(option_text(camera), "--view \"follow:the blue one\" --zoom 1.5");
}

}  // namespace
}  // namespace wuerfel::test
