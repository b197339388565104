// Checkpoints with a right check sum: taken up, or refused.
#include "app/output/checkpoint.h"

#include "app/cli/scene_source.h"
#include "core/scene/scene_parser.h"
#include "core/time/restart_point.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  static const Scene scene =
      parse_scene("[[plane]]\n[[cube]]\nname = \"a\"\non = \"plane1\"\n", "scene");
  static const std::string origin = checkpoint_origin(scene, {});
  const std::string body = origin + fuzz::text_of(data, size);
  const std::string file = "wuerfel checkpoint\n" + text_hash(body) + "\n" + body;
  try {
    const Checkpoint checkpoint = parse_checkpoint(file, "file", origin);
    for (const Moment& moment : checkpoint.moments)
      (void)contacts_of(moment.loaded, 2);
    (void)restart_point_of(checkpoint.restart_point, scene.cubes.size());
  } catch (const UsageError&) {
  } catch (const RestartError&) {
  }
  return 0;
}
