#include "model/scene/scene.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// A scene or a plan, in the folder of an example, whose files it may name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path folder = MIXCMP_SOURCE_DIR "/examples/sphere_collision";
  const scene::SceneSource source(folder / "fuzzed.toml", test::text_of(data, size));
  test::is_read(scene::load_scene(source, {}));
  return 0;
}
